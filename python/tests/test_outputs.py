"""Arrays given for the results, and the clouds that groundgrid-py writes of them."""

import laspy
import numpy as np
import pytest
from las_files import write_las

import groundgrid
from groundgrid import GroundGrid
from groundgrid.program.main import main


def test_writes_into_out(plane):
    grid = GroundGrid(sensor_height_m=1.5)
    labels = np.full(len(plane), 9, np.uint8)
    heights = np.full(len(plane), 9, np.float32)
    result = grid.process(plane, out=(labels, heights))
    assert result.labels is labels and result.height_above_ground is heights
    expected = GroundGrid(sensor_height_m=1.5).process(plane)
    np.testing.assert_array_equal(labels, expected.labels)
    np.testing.assert_array_equal(heights, expected.height_above_ground)


def bad_outputs(n):
    labels, heights = np.zeros(n, np.uint8), np.zeros(n, np.float32)
    frozen = np.empty(n, np.uint8)
    frozen.flags.writeable = False
    both = np.empty(4 * n, np.uint8)
    odd = np.empty(4 * n + 1, np.uint8)[1:].view(np.float32)
    return [
        (labels, TypeError, "pair"),
        (3, TypeError, "pair"),
        ((labels, heights, labels), TypeError, "pair"),
        ((heights, labels), ValueError, "labels as a uint8 array"),
        ((labels[1:], heights), ValueError, "uint8"),
        ((labels, heights.astype(np.float64)), ValueError, "float32"),
        ((labels, np.empty(2 * n, np.float32)[::2]), ValueError, "without gaps"),
        ((labels, heights[::-1]), ValueError, "without gaps"),
        ((labels, odd), ValueError, "aligned"),
        ((labels.reshape(1, -1), heights), ValueError, "uint8"),
        ((frozen, heights), ValueError, "read-only"),
        ((both[:n], both.view(np.float32)), ValueError, "share memory"),
        ((None, None), (TypeError, ValueError), "labels"),
        ((labels, [0.0] * n), (TypeError, ValueError), "heights"),
    ]


@pytest.mark.parametrize("case", range(len(bad_outputs(2))))
def test_other_outputs_are_refused_with_the_map_untouched(plane, case):
    grid = GroundGrid(sensor_height_m=1.5)
    out, error, words = bad_outputs(len(plane))[case]
    with pytest.raises(error, match=words):
        grid.process(plane, out=out)
    assert grid.terrain.size == 0


def test_outputs_must_not_lie_in_the_points(plane):
    points = np.column_stack([plane, plane])
    memory = points.reshape(-1)
    labels = np.empty(len(plane), np.uint8)
    with pytest.raises(ValueError, match="share memory"):
        GroundGrid().process(points, out=(labels, memory[: len(plane)]))
    with pytest.raises(ValueError, match="share memory"):
        GroundGrid().process(points[::-1], out=(labels, memory[: len(plane)]))


@pytest.mark.parametrize("ending", ["pcd", "ply", "las", "laz"])
@pytest.mark.parametrize("name", ["scan.npy", "scan.las"])
def test_a_scan_without_points_is_a_cloud_without_points(tmp_path, name, ending):
    np.save(tmp_path / "scan.npy", np.zeros((0, 4), np.float32))
    write_las(tmp_path / "scan.las", np.zeros((0, 3)))
    out = tmp_path / "out"
    assert main(["run", str(tmp_path / name), "--output", str(out), "--clouds", ending]) == 0
    (scan,) = groundgrid.datasets.open(out / f"scan.{ending}")
    assert scan.points.shape == (0, 4)
    assert "height_above_ground" in scan.fields and (out / "run.json").exists()


@pytest.mark.parametrize("ending", ["pcd", "ply"])
def test_names_of_fields_have_no_blanks_in_clouds(tmp_path, plane, ending):
    numbers = {name: np.full(len(plane), number, np.uint8) for number, name in enumerate(
        ["Pulse width", "Pulse_width", "Pulse\t width", " label", "\u3000"])}
    np.savez(tmp_path / "scan.npz", points=plane, **numbers)
    out = tmp_path / "out"
    flags = ["--output", str(out), "--clouds", ending]
    assert main(["run", str(tmp_path / "scan.npz"), *flags]) == 0
    fields = groundgrid.datasets.open(out / f"scan.{ending}")[0].fields
    names = ["Pulse_width_2", "Pulse_width", "Pulse_width_3", "label_2", "unnamed"]
    assert list(fields) == ["x", "y", "z", *names, "label", "height_above_ground"]
    assert [fields[name][0] for name in names] == [0, 1, 2, 3, 4]
    np.testing.assert_array_equal(fields["x"], plane[:, 0])


def test_extra_bytes_of_a_las_file_may_have_blanks_in_their_name(tmp_path):
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.add_extra_dim(laspy.ExtraBytesParams("Pulse width", "uint8"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = np.ones((3, 4))
    las["Pulse width"] = np.arange(4)
    las.write(tmp_path / "scan.las")
    out = tmp_path / "out"
    flags = ["--output", str(out), "--clouds", "pcd"]
    assert main(["run", str(tmp_path / "scan.las"), *flags]) == 0
    fields = groundgrid.datasets.open(out / "scan.pcd")[0].fields
    assert fields["Pulse_width"].tolist() == [0, 1, 2, 3]


@pytest.mark.parametrize("wrong", [1e30, -2.5e6, np.inf, np.nan])
@pytest.mark.parametrize("pose", [None, np.diag([1.0, -1.0, -1.0, 1.0])])
def test_points_that_las_cannot_hold_are_left_out(tmp_path, plane, wrong, pose):
    points = np.insert(plane, 5, [1.0, wrong, 1.0], axis=0)
    np.savez(tmp_path / "scan.npz", points=points, **({} if pose is None else {"pose": pose}))
    out = tmp_path / "out"
    flags = ["--output", str(out), "--clouds", "las"]
    assert main(["run", str(tmp_path / "scan.npz"), *flags]) == 0
    las = laspy.read(out / "scan.las")
    expected = plane if pose is None else plane * [1, -1, -1]
    np.testing.assert_allclose(las.xyz, expected, atol=6e-4)
    assert np.isfinite(las.height_above_ground).all()
    assert np.fromfile(out / "scan.label", np.uint32).size == len(points)
