"""The comparison's own code, with methods made up for it: no peer, no network. The program judges
as it does for users; GROUNDGRID_PROGRAM is its path."""

import contextlib
import csv
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import types
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "peers"))

import compare
import numpy as np
import results
import runs
from package_peers import peers
from sequences import ComparisonError, find_sequences

PROGRAM = os.environ["GROUNDGRID_PROGRAM"]

# x, z and class. BelowOneMetre gets two right, one building wrong, misses two; vegetation and
# unlabeled are not counted: TP 2, FP 1, FN 2, TN 1.
MIXED = [(1, -2, 40), (2, -2, 48), (3, 0, 72), (4, -2, 50), (5, 0, 10), (6, -2, 70), (7, -2, 0),
         (8, 0, 40)]
# TP 1, TN 1.
RIGHT = [(1, -2, 40), (15, 0, 50)]
# FN 1, at 15 m.
MISSED = [(1, 0, 50), (15, 0, 40)]


class BelowOneMetre:
    def __init__(self, sensor_height_m):
        self.sensor_height_m = sensor_height_m

    def segment(self, points):
        return peers.Answer(points[:, 2] < -1, own_ms=1.5)


class Everything:
    def __init__(self, _):
        os.write(1, b"noise of a peer")

    def segment(self, points):
        return peers.Answer(np.ones(len(points), bool))


FAKES = {"below": BelowOneMetre, "everything": Everything}


class Settings:
    @staticmethod
    def paper():
        return Settings()


class SlowGrid:
    """Of a Python package that takes 2 ms a scan, and 20 after a reset."""

    def __init__(self, config, threads, sensor_height_m):
        self.seconds = 0.002

    def reset(self):
        self.seconds = 0.02

    def process(self, points, pose):
        time.sleep(self.seconds)


def package_of(scans):
    """In place of the Python package: whether that is installed must not matter to these tests."""
    scan = types.SimpleNamespace(points=None, pose=None)
    package = types.ModuleType("groundgrid")
    package.Config = Settings
    package.GroundGrid = SlowGrid
    package.datasets = types.SimpleNamespace(open=lambda *_, **__: [scan] * scans)
    return unittest.mock.patch.dict(sys.modules, {"groundgrid": package})


def without_package():
    return unittest.mock.patch.dict(sys.modules, {"groundgrid": None})


def write_sequence(dataset, name, scans):
    folder = dataset / "sequences" / name
    for kind in ("velodyne", "labels"):
        (folder / kind).mkdir(parents=True)
    for i, scan in enumerate(scans):
        points = np.array([[x, 0, z, 0.5] for x, z, _ in scan], np.float32)
        points.tofile(folder / "velodyne" / f"{i:06d}.bin")
        classes = np.array([label for _, _, label in scan], np.uint32)
        classes.tofile(folder / "labels" / f"{i:06d}.label")
    return folder


def write_poses(folder, scans):
    standing = "1 0 0 0 0 1 0 0 0 0 1 0\n"
    (folder / "poses.txt").write_text(scans * standing)
    (folder / "calib.txt").write_text(f"Tr: {standing}")


def write_predictions(folder, sequence, scans):
    predictions = folder / "sequences" / sequence / "predictions"
    predictions.mkdir(parents=True)
    for i, labels in enumerate(scans):
        np.array(labels, np.uint32).tofile(predictions / f"{i:06d}.label")


class CompareTest(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.data = self.folder / "data"

    def run_compare(self, *arguments, fakes=FAKES):
        """What it prints."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            compare.main([*map(str, arguments), "--program", PROGRAM], fakes)
        return out.getvalue()

    def figures(self, *arguments, fakes=FAKES):
        printed = json.loads(self.run_compare(*arguments, "--json", fakes=fakes))
        return {(one["method"], one["title"]): one for one in printed["results"]}

    def refused(self, *arguments, fakes=FAKES):
        """What it says as it ends."""
        with self.assertRaises(SystemExit) as ended:
            self.run_compare(*arguments, fakes=fakes)
        return str(ended.exception.code)

    def test_counts_are_pooled_over_scans_and_ious_averaged_over_sequences(self):
        write_sequence(self.data, "00", [MIXED, RIGHT])
        write_sequence(self.data, "03", [RIGHT, MISSED])
        printed = self.run_compare(self.data, "--methods", "below,everything")
        # 00: 3 / (3 + 1 + 2); 03: 1 / (1 + 0 + 1). Everything: 5 / (5 + 3), 2 / (2 + 2).
        self.assertIn("| | 00 | 03 | mean |", printed)
        self.assertIn("| below | 50.00 | **50.00** | 50.00 |", printed)
        self.assertIn("| everything | **62.50** | **50.00** | **56.25** |", printed)

    def test_distances_are_pooled_over_the_sequences(self):
        write_sequence(self.data, "00", [MIXED, RIGHT])
        write_sequence(self.data, "03", [RIGHT, MISSED])
        printed = self.run_compare(self.data, "--methods", "everything")
        # Nearer than 10 m: 4 + 1 + 1 of (6 + 1) + 1 + 1 points; beyond: 1 of 3.
        self.assertIn("| | 0-10 m | 10-20 m |\n", printed)
        self.assertIn("| everything | **66.67** | **33.33** |\n", printed)

    def test_only_points_up_to_50_m_count_for_the_first_table(self):
        write_sequence(self.data, "00", [[(1, -2, 40), (60, -2, 50)]])
        printed = self.run_compare(self.data, "--methods", "everything")
        first, whole = printed.split("at all distances")
        self.assertIn("| everything | **100.00** | **100.00** |", first)
        self.assertIn("| everything | **50.00** | **50.00** |", whole)
        self.assertNotIn("50+", printed)

    def test_there_is_one_table_where_no_point_is_farther(self):
        write_sequence(self.data, "00", [RIGHT])
        self.assertNotIn("at all distances", self.run_compare(self.data, "--methods", "below"))

    def test_predictions_of_another_method_join(self):
        write_sequence(self.data, "00", [RIGHT])
        write_predictions(self.folder / "other", "00", [[50, 40]])
        figures = self.figures(self.data, "--methods", "below",
                               "--predictions", f"other={self.folder / 'other'}")
        self.assertEqual(figures["below", "00"]["iou"], 1)
        self.assertEqual(figures["other", "00"]["iou"], 0)
        self.assertIsNone(figures["other", "00"]["own_ms_median"])

    def test_points_without_an_answer_count_nowhere_and_are_told(self):
        write_sequence(self.data, "00", [[(1, -2, 40), (15, -2, 40)]])
        write_predictions(self.folder / "other", "00", [[40, 0]])
        printed = self.run_compare(self.data, "--methods", "",
                                   "--predictions", f"other={self.folder / 'other'}")
        self.assertIn("| other | **100.00** | **100.00** |", printed)
        self.assertIn("other leaves 50.00 % of the points of the real scans unanswered", printed)

    def test_simulated_drives_stand_apart_and_tell_their_sensor_height(self):
        write_sequence(self.data, "00", [RIGHT])
        truth = write_sequence(self.data, "01", [RIGHT]) / "truth"
        truth.mkdir()
        mounting = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1.2], [0, 0, 0, 1]]
        (truth / "drive.json").write_text(
            json.dumps({"scene": "hill", "T_base_sensor": mounting}))
        heights = []

        def recording(sensor_height_m):
            heights.append(sensor_height_m)
            return BelowOneMetre(sensor_height_m)

        printed = self.run_compare(self.data, "--methods", "below", fakes={"below": recording})
        self.assertEqual(heights, [1.73, 1.2])
        self.assertIn("up to 50 m, real scans\n\n| | 00 | mean |", printed)
        self.assertIn("up to 50 m, simulated drives\n\n| | hill | mean |", printed)

    def test_methods_take_turns_in_going_first_and_start_anew(self):
        write_sequence(self.data, "00", [RIGHT])
        made = []
        fakes = {name: lambda height, name=name: made.append(name) or BelowOneMetre(height)
                 for name in ("a", "b", "c")}
        self.run_compare(self.data, "--methods", "a,b,c", "--repetitions", 2, fakes=fakes)
        self.assertEqual("".join(made), "abcbca")

    def test_ours_is_timed_from_python_where_the_package_is(self):
        write_poses(write_sequence(self.data, "00", [RIGHT, MIXED]), 2)
        calls = []

        class Grid:
            def __init__(self, config, threads, sensor_height_m):
                calls.append((config, threads, sensor_height_m))

            def reset(self):
                calls.append("reset")

            def process(self, points, pose):
                calls.append((points, pose))

        class Config:
            def __new__(cls):
                return "default"

            @staticmethod
            def paper():
                return "paper"

        scans = [types.SimpleNamespace(points=f"points {i}", pose=f"pose {i}") for i in range(2)]
        datasets = types.SimpleNamespace(open=lambda dataset, sequence: scans)
        package = types.SimpleNamespace(GroundGrid=Grid, Config=Config, datasets=datasets)
        processed = [("points 0", "pose 0"), ("points 1", "pose 1")]
        with unittest.mock.patch.dict(sys.modules, groundgrid=package):
            for method, expected in (
                    ("groundgrid", [("default", 1, 1.73), *processed]),
                    ("groundgrid paper", [("paper", 1, 1.73), *processed]),
                    ("groundgrid single scan", [("default", 1, 1.73), "reset", processed[0],
                                                "reset", processed[1]])):
                figures = self.figures(self.data, "--methods", method)
                self.assertEqual(calls, expected)
                self.assertGreater(figures[method, "00"]["call_ms_median"], 0)
                self.assertGreater(figures[method, "00"]["own_ms_median"], 0)
                calls.clear()

    def test_without_the_package_only_the_program_is_timed(self):
        write_poses(write_sequence(self.data, "00", [RIGHT]), 1)
        with unittest.mock.patch.dict(sys.modules, groundgrid=None):
            figures = self.figures(self.data, "--methods", "groundgrid")
        self.assertIsNone(figures["groundgrid", "00"]["call_ms_median"])
        self.assertGreater(figures["groundgrid", "00"]["own_ms_median"], 0)

    def test_what_a_peer_prints_does_not_reach_the_results(self):
        write_sequence(self.data, "00", [RIGHT])
        with tempfile.TemporaryFile() as stdout:
            kept = os.dup(1)
            os.dup2(stdout.fileno(), 1)
            try:
                self.run_compare(self.data, "--methods", "everything")
            finally:
                os.dup2(kept, 1)
                os.close(kept)
            stdout.seek(0)
            self.assertEqual(stdout.read(), b"")

    def test_csv_has_a_row_for_each_distance_and_one_with_times_for_all(self):
        write_sequence(self.data, "00", [MIXED])
        self.run_compare(self.data, "--methods", "below", "--csv", self.folder / "out.csv")
        with open(self.folder / "out.csv", newline="") as file:
            rows = {row["distance"]: row for row in csv.DictReader(file)}
        whole, near = rows["all"], rows["0-10 m"]
        self.assertEqual([whole[name] for name in results.COUNTS], ["2", "1", "2", "1", "0"])
        self.assertEqual((whole["iou"], near["iou"]), ("40.0000", "40.0000"))
        self.assertEqual((whole["own_ms_median"], near["own_ms_median"]), ("1.5", ""))
        self.assertGreater(float(whole["call_ms_median"]), 0)
        self.assertEqual(rows["10-20 m"]["iou"], "nan")

    def test_the_labels_are_kept_where_asked(self):
        write_sequence(self.data, "00", [RIGHT])
        self.run_compare(self.data, "--methods", "below", "--output", self.folder / "kept")
        labels = np.fromfile(self.folder / "kept/0/below/sequences/00/predictions/000000.label",
                             np.uint32)
        self.assertEqual(list(labels), [40, 99])

    def test_a_peer_that_is_not_installed_names_the_requirements(self):
        write_sequence(self.data, "00", [RIGHT])
        fakes = {"gone": lambda _: peers.package("no_such_package", "Gone")}
        said = self.refused(self.data, "--methods", "gone", fakes=fakes)
        self.assertIn("Gone cannot be loaded", said)
        self.assertIn("requirements.txt", said)

    def test_a_dataset_without_labels_is_refused(self):
        (write_sequence(self.data, "00", [RIGHT]) / "labels").rename(self.folder / "away")
        self.assertIn(f"below {self.data}", self.refused(self.data, "--methods", "below"))

    def test_a_sequence_that_is_not_there_is_refused(self):
        write_sequence(self.data, "00", [RIGHT])
        self.assertIn("is one of 07", self.refused(self.data, "--sequence", "07"))

    def test_an_unknown_method_is_a_mistake_of_usage(self):
        self.assertEqual(self.refused(self.data, "--methods", "best"), "2")

    def test_nothing_to_compare_is_refused(self):
        write_sequence(self.data, "00", [RIGHT])
        self.assertIn("nothing to compare", self.refused(self.data, "--methods", ""))

    def test_predictions_for_two_sequences_of_one_name_are_refused(self):
        for name in ("one", "two"):
            write_sequence(self.folder / name, "00", [RIGHT])
        said = self.refused(self.folder / "one", self.folder / "two", "--methods", "",
                            "--predictions", f"other={self.folder}")
        self.assertIn("one dataset at a time", said)

    def test_what_the_program_refuses_is_said(self):
        write_sequence(self.data, "00", [RIGHT])
        write_predictions(self.folder / "other", "00", [[40, 50, 40]])
        said = self.refused(self.data, "--methods", "",
                            "--predictions", f"other={self.folder / 'other'}")
        self.assertIn("000000.label", said)

    def simulate(self, scans):
        subprocess.run([PROGRAM, "simulate", "urban", self.data, "--sensor", "vlp-16", "--scans",
                        str(scans)], check=True, capture_output=True)

    def test_our_methods_are_the_program_with_its_flags(self):
        self.simulate(3)
        with without_package():
            found = self.figures(self.data, "--methods", ",".join(compare.OURS))
        ious = {method: one["iou"] for (method, _), one in found.items()}
        for method, flags in compare.OURS.items():
            evaluated = runs.call_program([PROGRAM, "evaluate", self.data,
                                           "--leave-unanswered-out", "--json", *flags])
            self.assertEqual(ious[method], json.loads(evaluated)["sequences"][0]["iou"])
        self.assertEqual(len(set(ious.values())), 3)
        self.assertGreater(found["groundgrid", "urban"]["own_ms_median"], 0)
        self.assertIsNone(found["groundgrid", "urban"]["call_ms_median"])

    def test_our_methods_are_called_from_python_where_the_package_is(self):
        self.simulate(2)
        with package_of(2):
            found = self.figures(self.data, "--methods", "groundgrid,groundgrid single scan")
        warm, single = (found[name, "urban"]["call_ms_median"]
                        for name in ("groundgrid", "groundgrid single scan"))
        self.assertTrue(2 <= warm and 20 <= single, (warm, single))


class ResultTest(unittest.TestCase):
    def test_a_scan_has_the_median_of_its_repetitions(self):
        repetitions = [[runs.ScanTime(call=a), runs.ScanTime(call=b)]
                       for a, b in ((1, 10), (3, 90), (2, 20))]
        result = results.Result("any", None, {}, repetitions)
        self.assertEqual(list(result.milliseconds("call")), [2, 20])
        self.assertEqual(len(result.milliseconds("own")), 0)

    def test_the_summary_has_median_and_95_percent_over_the_scans(self):
        times = [runs.ScanTime(own=milliseconds) for milliseconds in range(1, 22)]
        summary = results.times_summary(results.Result("any", None, {}, [times]))
        self.assertEqual((summary["own_ms_median"], summary["own_ms_95"]), (11, 20))

    def test_iou_without_ground_is_no_number(self):
        self.assertTrue(np.isnan(results.iou({"tp": 0, "fp": 0, "fn": 0})))


class SequencesTest(unittest.TestCase):
    def test_scans_come_in_their_order(self):
        with tempfile.TemporaryDirectory() as name:
            write_sequence(pathlib.Path(name), "00", [RIGHT] * 11)
            (sequence,) = find_sequences([pathlib.Path(name)], None)
            self.assertEqual([scan.stem for scan in sequence.scans],
                             [f"{i:06d}" for i in range(11)])

    def test_a_folder_that_is_not_there_is_refused(self):
        with self.assertRaises(ComparisonError):
            find_sequences([pathlib.Path("no/such/folder")], None)


if __name__ == "__main__":
    unittest.main()
