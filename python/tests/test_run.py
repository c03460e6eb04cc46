"""groundgrid-py run, on a simulated drive in files of several kinds."""

import json
import os
import re
import sqlite3
import subprocess
import sys
from contextlib import closing

import laspy
import numpy as np
import pytest
import rasterio
from test_bags import STORE, cloud, tf, write

import groundgrid
from groundgrid import Label
from groundgrid.evaluation import to_semantic_kitti
from groundgrid.program.main import main


@pytest.fixture(scope="module")
def folder(drive, tmp_path_factory):
    folder = tmp_path_factory.mktemp("drive")
    for number, scan in enumerate(drive):
        np.savez(folder / f"{number}.npz", points=scan.points, pose=scan.pose,
                 ring=np.arange(len(scan.points), dtype=np.uint16) % 16)
    return folder


@pytest.fixture(scope="module")
def answers(folder):
    grid = groundgrid.GroundGrid()
    return [(scan, grid.process(scan.points, scan.pose))
            for scan in groundgrid.datasets.open(folder)]


def names_in(folder):
    return sorted(each.name for each in folder.iterdir())


def test_labels_are_those_of_the_library(folder, answers, tmp_path, capsys):
    assert main(["run", str(folder), "--output", str(tmp_path / "out")]) == 0
    assert names_in(tmp_path / "out") == ["0.label", "1.label", "2.label", "run.json"]
    for number, (_, result) in enumerate(answers):
        labels = np.fromfile(tmp_path / "out" / f"{number}.label", np.uint32)
        np.testing.assert_array_equal(labels, to_semantic_kitti(result.labels))
    record = json.loads((tmp_path / "out" / "run.json").read_text())
    assert record["scans"] == 3 and record["sensor_height_estimated"]
    ground = sum(int((result.labels == Label.GROUND).sum()) for _, result in answers)
    assert record["counts"]["ground"] == ground
    assert "3 scans" in capsys.readouterr().out


@pytest.mark.parametrize("ending", ["pcd", "ply"])
def test_clouds_keep_every_field(folder, answers, tmp_path, ending):
    assert main(["run", str(folder), "--output", str(tmp_path), "--clouds", ending]) == 0
    clouds = groundgrid.datasets.FileDataset(tmp_path)
    for cloud_with_labels, (scan, result) in zip(clouds, answers, strict=True):
        np.testing.assert_array_equal(cloud_with_labels.points, scan.points)
        fields = cloud_with_labels.fields
        assert list(fields) == [*scan.fields, "label", "height_above_ground"]
        np.testing.assert_array_equal(fields["ring"], scan.fields["ring"])
        np.testing.assert_array_equal(fields["label"], to_semantic_kitti(result.labels))
        np.testing.assert_array_equal(fields["height_above_ground"], result.height_above_ground)


def test_las_has_the_classes_of_asprs_in_the_map(folder, answers, tmp_path):
    assert main(["run", str(folder), "--output", str(tmp_path), "--clouds", "laz"]) == 0
    scan, result = answers[2]
    las = laspy.read(tmp_path / "2.laz")
    finite = np.isfinite(scan.points[:, :3]).all(axis=1)
    expected = np.select([result.labels == Label.GROUND, result.labels == Label.OBSTACLE,
                          result.labels == Label.OUTLIER], [2, 1, 7], 0)[finite]
    np.testing.assert_array_equal(las.classification, expected)
    places = scan.points[finite, :3] @ scan.pose[:3, :3].T + scan.pose[:3, 3]
    np.testing.assert_allclose(np.stack([las.x, las.y, las.z], 1), places, atol=6e-4)


def test_a_las_file_comes_back_with_other_classes(answers, tmp_path):
    from las_files import geo_keys, write_las

    points = answers[0][0].points[:, :3].astype(float)
    write_las(tmp_path / "scan.las", points + [500000, 5000000, 100], np.full(len(points), 5),
              geo_keys(projected=32632), scale=1e-5, user_data=np.arange(len(points)) % 200)
    flags = ["--output", str(tmp_path / "out"), "--clouds", "las", "--single-scan"]
    assert main(["run", str(tmp_path / "scan.las"), *flags]) == 0
    before, after = laspy.read(tmp_path / "scan.las"), laspy.read(tmp_path / "out" / "scan.las")
    np.testing.assert_array_equal(before.X, after.X)
    np.testing.assert_array_equal(before.user_data, after.user_data)
    labels = np.fromfile(tmp_path / "out" / "scan.label", np.uint32)
    np.testing.assert_array_equal(after.classification == 2, labels == 40)
    assert (labels == 40).mean() > 0.2 and after.header.parse_crs is not None
    assert any(hasattr(vlr, "geo_keys") for vlr in after.header.vlrs)


def test_the_terrain_is_a_raster_of_the_drive(folder, answers, tmp_path):
    flags = ["--output", str(tmp_path), "--terrain", "--crs", "EPSG:32632"]
    assert main(["run", str(folder), *flags]) == 0
    with rasterio.open(tmp_path / "terrain.tif") as raster:
        assert raster.descriptions == ("height", "confidence", "count", "density",
                                       "standard deviation")
        assert raster.units[0] == "m" and raster.crs.to_epsg() == 32632
        assert raster.res == (0.33, 0.33)
        heights, confidence = raster.read(1, masked=True), raster.read(2, masked=True)
        pose = answers[0][0].pose
        below = next(iter(raster.sample([(pose[0, 3] + 6, pose[1, 3])])))
    # The street under the vehicle's nose, and a sensor some 1.7 m above it.
    assert pose[2, 3] - below[0] == pytest.approx(answers[0][1].sensor_height_m, abs=0.15)
    assert heights.count() > 3000 and 0 <= confidence.min() and confidence.max() <= 1


@pytest.fixture
def recording(folder, tmp_path):
    """Three clouds of the drive between transforms."""
    messages = []
    for number, scan in enumerate(groundgrid.datasets.open(folder)):
        message = cloud(STORE, "plain", 0, number, "lidar")
        data = np.ascontiguousarray(scan.points).view(np.uint8).reshape(-1)
        for name, value in {"width": len(scan.points), "row_step": data.size, "data": data}.items():
            object.__setattr__(message, name, value)
        place = tuple(float(each) for each in scan.pose[:3, 3])
        messages += [("/tf", tf(float(number), "map", "lidar", place), number),
                     ("/points", message, number + 0.1)]
    return messages


def test_scans_without_a_pose_are_told_counted_and_refused(recording, tmp_path, capsys):
    del recording[2]  # TF has the first and the last scan, and then but the first
    whole = write(tmp_path / "whole", recording, "MCAP")
    assert main(["run", str(whole), "--output", str(tmp_path / "a"), "--require-poses"]) == 0
    assert "warning" not in capsys.readouterr().err
    assert json.loads((tmp_path / "a" / "run.json").read_text())["single_scans"] == 0
    del recording[3]
    cut = write(tmp_path / "cut", recording, "MCAP")
    assert main(["run", str(cut), "--output", str(tmp_path / "b")]) == 0
    told = capsys.readouterr()
    reason = "its time is behind the poses of 'lidar' in 'map', which are from 0.000 to 0.000 s"
    assert told.err.count("warning") == 1 and "3 scans (2 of them single)" in told.out
    assert f"cut: scan 000001 of 1.000 s has no pose: {reason}; " in told.err
    record = json.loads((tmp_path / "b" / "run.json").read_text())
    assert record["single_scans"] == 2 and record["single_scans_because"] == {reason: 2}
    assert main(["run", str(cut), "--output", str(tmp_path / "c"), "--require-poses"]) == 1
    assert "scan 000001 of 1.000 s has no pose: " in capsys.readouterr().err
    assert "run.json" not in names_in(tmp_path / "c")


@pytest.mark.parametrize("scans", [1, 2])
def test_several_scans_of_an_input_without_poses_are_told_of(answers, tmp_path, capsys, scans):
    inside, out = tmp_path / "inside", tmp_path / "out"
    inside.mkdir()
    for number in range(scans):
        np.save(inside / f"{number}.npy", answers[number][0].points)
    assert main(["run", str(inside), "--output", str(out)]) == 0
    assert ("scan 1 has no pose: the input has none" in capsys.readouterr().err) == (scans == 2)
    assert json.loads((out / "run.json").read_text())["single_scans"] == scans
    assert main(["run", str(inside), "--output", str(out), "--single-scan"]) == 0
    assert "warning" not in capsys.readouterr().err
    for command in (["run", "--output", str(out)], ["view", "--output", str(tmp_path / "a.rrd")],
                    ["compare", "--methods", "groundgrid"]):
        assert main([command[0], str(inside), *command[1:], "--require-poses"]) == 1
        assert "scan 0 has no pose" in capsys.readouterr().err


@pytest.mark.parametrize("storage", ["SQLITE3", "MCAP"])
def test_a_recording_comes_back_with_labelled_clouds(recording, tmp_path, storage):
    bag = write(tmp_path / "drive", recording, storage)
    assert main(["run", str(bag), "--output", str(tmp_path / "out"), "--bag"]) == 0
    copy = tmp_path / "out" / "drive_labelled"
    before = groundgrid.datasets.open(bag)
    after = groundgrid.datasets.open(copy, topic="/points")
    labelled = groundgrid.datasets.open(copy, topic="/points/ground_grid")
    assert len(after) == len(labelled) == 3
    for number, (one, same, more) in enumerate(zip(before, after, labelled, strict=True)):
        np.testing.assert_array_equal(one.points, same.points)
        np.testing.assert_array_equal(one.pose, same.pose)
        np.testing.assert_array_equal(one.points, more.points)
        assert list(more.fields) == ["x", "y", "z", "intensity", "label", "height_above_ground"]
        labels = np.fromfile(tmp_path / "out" / f"00000{number}.label", np.uint32)
        np.testing.assert_array_equal(more.fields["label"], labels)
    assert names_in(tmp_path / "out") == ["000000.label", "000001.label", "000002.label",
                                          "drive_labelled", "run.json"]


def test_a_recording_of_ros_1_stays_one(tmp_path):
    from test_bags import STORE1

    messages = [("/points", cloud(STORE1, "velodyne", number, number), number)
                for number in range(2)]
    bag = write(tmp_path / "drive", messages, "ros1")
    flags = ["--bag", "--sensor-height-m", "1.5", "--output", str(tmp_path / "out")]
    assert main(["run", str(bag), *flags]) == 0
    labelled = groundgrid.datasets.open(tmp_path / "out" / "drive_labelled.bag",
                                        topic="/points/ground_grid")
    for one, more in zip(groundgrid.datasets.open(bag), labelled, strict=True):
        np.testing.assert_array_equal(one.fields["ring"], more.fields["ring"])
        assert more.fields["label"].dtype == np.uint32


@pytest.mark.parametrize("storage", ["ros1", "SQLITE3", "MCAP"])
def test_livox_messages_come_back_with_labelled_clouds(tmp_path, storage):
    from test_bags import livox, store_of

    messages = [("/livox/lidar", livox(store_of(storage), "livox_ros_driver2", 0), 0)]
    bag = write(tmp_path / "drive", messages, storage)
    if storage == "SQLITE3":
        as_of_humble(bag)
    flags = ["--bag", "--sensor-height-m", "1.5", "--output", str(tmp_path / "out")]
    assert main(["run", str(bag), *flags]) == 0
    ending = ".bag" if storage == "ros1" else ""
    copy = tmp_path / "out" / f"drive_labelled{ending}"
    (labelled,) = groundgrid.datasets.open(copy)
    (original,) = groundgrid.datasets.open(copy, topic="/livox/lidar")
    np.testing.assert_array_equal(labelled.points, original.points)
    np.testing.assert_array_equal(labelled.fields["t"], original.fields["t"])
    assert labelled.fields["label"].dtype == np.uint32


def labelled_copy(given, out):
    flags = ["--bag", "--sensor-height-m", "1.5", "--output", str(out)]
    assert main(["run", str(given), *flags]) == 0
    return groundgrid.datasets.open(out / f"{given.stem}_labelled", topic="/points/ground_grid")


@pytest.mark.parametrize("storage", ["SQLITE3", "MCAP"])
def test_a_lone_file_comes_back_as_a_recording(recording, tmp_path, storage):
    ending = {"SQLITE3": ".db3", "MCAP": ".mcap"}[storage]
    (file,) = write(tmp_path / "drive", recording, storage).glob(f"*{ending}")
    alone = file.rename(tmp_path / f"alone{ending}")
    for one, more in zip(groundgrid.datasets.open(alone), labelled_copy(alone, tmp_path / "out"),
                         strict=True):
        np.testing.assert_array_equal(one.points, more.points)
        np.testing.assert_array_equal(one.pose, more.pose)
        assert "label" in more.fields


def as_of_humble(bag):
    """What recordings were before types had hashes, and files of SQLite definitions."""
    metadata = bag / "metadata.yaml"
    text = re.sub(r"type_description_hash:\s+\S+", "", metadata.read_text())
    metadata.write_text(text.replace("version: 9", "version: 5"))
    for file in bag.glob("*.db3"):
        with closing(sqlite3.connect(file)) as base, base:
            base.execute("UPDATE schema SET schema_version = 3")
            base.execute("DROP TABLE message_definitions")


@pytest.mark.parametrize("storage", ["SQLITE3", "MCAP"])
def test_a_recording_of_an_older_ros_2_comes_back(recording, tmp_path, storage, capsys):
    bag = write(tmp_path / "drive", recording, storage)
    as_of_humble(bag)
    assert len(list(labelled_copy(bag, tmp_path / "out"))) == 3
    assert "left out" not in capsys.readouterr().err


def test_topics_of_unknown_types_are_left_out_and_named(recording, tmp_path, capsys):
    bag = write(tmp_path / "drive", recording, "SQLITE3")
    as_of_humble(bag)
    metadata = bag / "metadata.yaml"
    metadata.write_text(metadata.read_text().replace("tf2_msgs/msg/TFMessage", "mine/msg/Odd"))
    for file in bag.glob("*.db3"):
        with closing(sqlite3.connect(file)) as base, base:
            base.execute("UPDATE topics SET type = 'mine/msg/Odd' WHERE name = '/tf'")
    labelled = labelled_copy(bag, tmp_path / "out")
    assert "/tf is left out" in (told := capsys.readouterr().err) and "mine/msg/Odd" in told
    assert len(list(labelled)) == 3
    with labelled.reader() as copy:
        assert sorted(each.topic for each in copy.connections) == ["/points", "/points/ground_grid"]


@pytest.mark.parametrize("storage", ["ros1", "MCAP"])
def test_a_recording_is_not_labelled_twice(tmp_path, storage, capsys):
    from test_bags import store_of

    messages = [(topic, cloud(store_of(storage), "plain", 0), 0)
                for topic in ("/points", "/points/ground_grid")]
    bag = write(tmp_path / "drive", messages, storage)
    flags = ["--topic", "/points", "--bag", "--output", str(tmp_path / "out")]
    assert main(["run", str(bag), *flags]) == 1
    assert f"{bag}: expected no topic /points/ground_grid" in capsys.readouterr().err
    assert names_in(tmp_path / "out") == []


def test_a_run_that_fails_leaves_whole_files_and_no_record(folder, recording, tmp_path, capsys):
    bad = tmp_path / "bad"
    bad.mkdir()
    for name in ("0.npz", "1.npz"):
        (bad / name).write_bytes((folder / name).read_bytes())
    (bad / "2.npz").write_bytes(b"no scan")
    out = tmp_path / "out"
    flags = ["--output", str(out), "--terrain", "--clouds", "pcd"]
    assert main(["run", str(folder), "--output", str(out)]) == 0
    assert main(["run", str(bad), *flags]) == 1
    assert "2.npz: " in capsys.readouterr().err
    assert names_in(out) == ["0.label", "0.pcd", "1.label", "1.pcd", "2.label"]
    object.__setattr__(recording[5][1], "point_step", 14)
    bag = write(tmp_path / "drive", recording, "MCAP")
    assert main(["run", str(bag), "--bag", "--output", str(tmp_path / "bags")]) == 1
    assert names_in(tmp_path / "bags") == ["000000.label", "000001.label"]


@pytest.mark.parametrize(
    ("flags", "words"),
    [
        (["--bag"], "--bag: expected a recording"),
        (["--require-poses", "--single-scan"], "--require-poses: expected without --single-scan"),
        (["--crs", "EPSG:32632"], "--crs: expected together with --terrain"),
        (["--terrain", "--crs", "EPSG:4326"], "crs: expected one whose x and y are metres"),
        (["--terrain", "--crs", "nowhere"], "crs: expected one that PROJ knows"),
        (["--topic", "/points"], "expected options that this kind of input has, got --topic"),
        (["--poses", "nothing.txt"], "nothing.txt"),
        (["--set", "resolution_m"], "--set: expected NAME=VALUE"),
        (["--set", "cell_sze_m=1"], "--set: expected NAME=VALUE"),
        (["--set", "resolution_m=-1"], "resolution_m"),
        (["--set", "min_range_m=many"], "--set: "),
        (["--calibration", "calib.txt"], "got --calibration"),
        (["--config", "nothing.toml"], "nothing.toml"),
    ],
)
def test_what_cannot_be_is_said(folder, tmp_path, capsys, flags, words):
    assert main(["run", str(folder), "--output", str(tmp_path / "out"), *flags]) == 1
    error = capsys.readouterr().err
    assert error.startswith("groundgrid-py: ") and words in error
    assert not list(tmp_path.rglob("*.*"))


def test_clouds_never_replace_the_input(folder, tmp_path, capsys):
    (tmp_path / "0.npz").write_bytes((folder / "0.npz").read_bytes())
    scans = tmp_path / "clouds"
    assert main(["run", str(tmp_path), "--output", str(scans), "--clouds", "pcd"]) == 0
    assert main(["run", str(scans), "--output", str(scans), "--clouds", "pcd"]) == 1
    assert "expected another folder for --output" in capsys.readouterr().err


def test_clouds_never_replace_what_is_linked_or_listed(folder, tmp_path, capsys):
    scans, links, listed = tmp_path / "scans", tmp_path / "links", tmp_path / "list.txt"
    (tmp_path / "0.npz").write_bytes((folder / "0.npz").read_bytes())
    assert main(["run", str(tmp_path), "--output", str(scans), "--clouds", "pcd"]) == 0
    links.mkdir()
    (links / "0.pcd").symlink_to(scans / "0.pcd")
    listed.write_text("scans/0.pcd\n")
    before = (scans / "0.pcd").read_bytes()
    for source in (links, listed):
        assert main(["run", str(source), "--output", str(scans), "--clouds", "pcd"]) == 1
        assert "0.pcd: expected another file for --output" in capsys.readouterr().err
        assert (scans / "0.pcd").read_bytes() == before


def test_results_of_one_name_are_refused(folder, tmp_path, capsys):
    for name in ("0.npz", "1.npz"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    np.save(tmp_path / "1.npy", np.zeros((4, 3), np.float32))
    assert main(["run", str(tmp_path), "--output", str(tmp_path / "out")]) == 1
    error = capsys.readouterr().err
    assert "expected one file a scan, got" in error and "1.npz" in error and "1.npy" in error


def test_scans_without_a_pose_have_terrains_of_their_own(answers, tmp_path):
    scans, out = tmp_path / "scans", tmp_path / "out"
    scans.mkdir()
    for number, (scan, _) in enumerate(answers):
        pose = {"pose": scan.pose} if number > 0 else {}
        np.savez(scans / f"{number}.npz", points=scan.points, **pose)
    assert main(["run", str(scans), "--output", str(out), "--terrain"]) == 0
    assert {"0.tif", "terrain.tif"} <= set(names_in(out)) and "1.tif" not in names_in(out)
    with rasterio.open(out / "0.tif") as lone, rasterio.open(out / "terrain.tif") as drive:
        assert lone.bounds.left < 0 < lone.bounds.right
        assert lone.read(1, masked=True).count() > 1000 and drive.read(1, masked=True).count() > 1000
    flags = ["--output", str(tmp_path / "single"), "--terrain", "--single-scan"]
    assert main(["run", str(scans), *flags]) == 0
    assert [name for name in names_in(tmp_path / "single") if name.endswith(".tif")] == [
        "0.tif", "1.tif", "2.tif"]


def test_a_scan_that_cannot_be_processed_is_named(answers, tmp_path, capsys):
    pose = np.diag([2.0, 1.0, 1.0, 1.0])
    np.savez(tmp_path / "7.npz", points=answers[0][0].points, pose=pose)
    assert main(["run", str(tmp_path), "--output", str(tmp_path / "out")]) == 1
    error = capsys.readouterr().err
    assert str(tmp_path) in error and "7" in error and "rigid" in error


def test_options_are_not_abbreviated(folder, tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(["run", str(folder), "--output", str(tmp_path), "--sensor-h", "1.0"])
    assert ended.value.code == 2 and "--sensor-h" in capsys.readouterr().err


def test_a_format_can_be_forced(scan, tmp_path):
    records = np.zeros((len(scan.points), 4), np.float32)
    records[:, :3] = scan.points[:, :3]
    records.tofile(tmp_path / "scan.raw")
    flags = ["--output", str(tmp_path / "out"), "--format", "kitti"]
    assert main(["run", str(tmp_path / "scan.raw"), *flags]) == 0
    assert names_in(tmp_path / "out") == ["run.json", "scan.label"]


def test_names_may_be_any_bytes(scan, tmp_path):
    folder = tmp_path / os.fsdecode(b"d\xff")
    folder.mkdir()
    records = np.zeros((len(scan.points), 4), np.float32)
    records[:, :3] = scan.points[:, :3]
    records.tofile(folder / os.fsdecode(b"s\xfe.bin"))
    assert main(["run", str(folder), "--output", str(folder / "out"), "--clouds", "pcd"]) == 0
    assert names_in(folder / "out") == ["run.json", os.fsdecode(b"s\xfe.label"),
                                        os.fsdecode(b"s\xfe.pcd")]


def test_parameters_reach_the_method(folder, tmp_path):
    flags = ["--preset", "paper", "--set", "resolution_m=0.5", "--threads", "2", "--scans", "1",
             "--sensor-height-m", "1.7"]
    assert main(["run", str(folder), "--output", str(tmp_path), *flags]) == 0
    record = json.loads((tmp_path / "run.json").read_text())
    expected = groundgrid.Config.paper().replace(resolution_m=0.5, sensor_height_m=1.7)
    assert record["config"] == expected.to_dict() and record["scans"] == 1
    assert names_in(tmp_path) == ["0.label", "run.json"]


def test_from_the_shell_there_is_no_traceback(tmp_path):
    command = [sys.executable, "-m", "groundgrid.program.main"]
    env = os.environ | {"PYTHONPATH": os.path.dirname(os.path.dirname(groundgrid.__file__))}
    failed = subprocess.run([*command, "run", "nothing.bag", "--output", str(tmp_path / "out")],
                            capture_output=True, text=True, env=env)
    assert failed.returncode == 1 and failed.stderr.startswith("groundgrid-py: nothing.bag: ")
    assert len(failed.stderr.splitlines()) == 1 and not (tmp_path / "out").exists()
    assert subprocess.run([*command, "run"], capture_output=True, env=env).returncode == 2
    version = subprocess.run([*command, "--version"], capture_output=True, text=True, env=env)
    assert version.stdout.strip() == groundgrid.__version__
