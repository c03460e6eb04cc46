"""Clouds in the coordinates of a map, and scans larger than the map or outside of it."""

import json
import re

import numpy as np
import pytest
from las_files import write_las
from test_bags import CLOUD, STORE, cloud, header, odometry, tf, write

import groundgrid
from groundgrid.datasets import BagDataset
from groundgrid.program.main import main

ORIGIN = np.array([388096.25, 5820000.5, 40.0])


@pytest.fixture
def utm(plane):
    return plane.astype(np.float64) + ORIGIN


def write_pcd(path, places):
    head = (f"VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {len(places)}\n"
            f"HEIGHT 1\nPOINTS {len(places)}\nDATA binary\n")
    path.write_bytes(head.encode() + places.tobytes())


def write_ply(path, places):
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(places)}\n"
            "property double x\nproperty double y\nproperty double z\nend_header\n")
    path.write_bytes(head.encode() + places.tobytes())


def double_cloud(places, frame="map"):
    field = STORE.types["sensor_msgs/msg/PointField"]
    fields = [field(name, 8 * column, 8, 1) for column, name in enumerate("xyz")]
    return STORE.types[CLOUD](header(STORE, 1.0, frame), 1, len(places), fields, False, 24,
                              24 * len(places), places.view(np.uint8).reshape(-1), True)


def write_scan(path, places):
    """Doubles in a file of this ending, or a recording."""
    places = np.ascontiguousarray(places)
    if path.suffix == "":
        return write(path, [("/points", double_cloud(places), 1.0)], "MCAP")
    {".npy": np.save, ".pcd": write_pcd, ".ply": write_ply, ".las": write_las}[path.suffix](
        path, places)
    return path


@pytest.mark.parametrize("name", ["a.pcd", "a.ply", "a.npy", "a.las", "a"])
def test_coordinates_of_a_map_are_told_from_the_middle(tmp_path, utm, name):
    (scan,) = groundgrid.datasets.open(write_scan(tmp_path / name, utm))
    assert np.abs(scan.points[:, :2]).max() < 12 and (scan.pose[:3, 3] % 1 == 0).all()
    np.testing.assert_array_equal(scan.pose[:3, :3], np.eye(3))
    np.testing.assert_allclose(scan.points[:, :3] + scan.pose[:3, 3], utm, atol=5e-4)
    assert scan.pose_missing is None


@pytest.mark.parametrize("name", ["a.pcd", "a.npy"])
def test_rays_without_a_return_and_stray_points_stay_what_they_are(tmp_path, utm, plane, name):
    odd = np.array([[0.0, 0, 0], [np.nan] * 3, [np.inf] * 3, [1e7, 1e7, 1e7]])
    # More rays without a return than points.
    rays = np.zeros((2 * len(utm), 3))
    path = write_scan(tmp_path / name, np.concatenate([odd, rays, utm]))
    (scan,) = groundgrid.datasets.open(path)
    assert np.abs(scan.points[-len(utm):, :2]).max() < 12
    np.testing.assert_array_equal(scan.points[:3, :3], odd[:3])
    assert not scan.points[4 : len(rays) + 4].any()
    near = np.concatenate([odd, plane.astype(np.float64)])
    (scan,) = groundgrid.datasets.open(write_scan(tmp_path / name, near))
    assert scan.pose is None
    np.testing.assert_array_equal(scan.points[:, :3], near.astype(np.float32))


@pytest.mark.parametrize("name", ["a.pcd", "a.npy", "a.las"])
def test_with_poses_coordinates_are_those_of_the_sensor(tmp_path, utm, name):
    (tmp_path / "poses.txt").write_text("1 0 0 0 0 1 0 0 0 0 1 0\n")
    path = write_scan(tmp_path / name, utm)
    (scan,) = groundgrid.datasets.open(path, poses=tmp_path / "poses.txt")
    np.testing.assert_allclose(scan.points[:, :3], utm, atol=0.5)
    np.testing.assert_array_equal(scan.pose, np.eye(4))


@pytest.fixture
def registered(tmp_path, plane):
    """Clouds in the frame that odometry places the sensor in, turned to the left by 90 degrees."""
    turned = np.stack([-plane[:, 1] + 200, plane[:, 0], plane[:, 2]], axis=1).astype(np.float64)
    pose = odometry(1.0, 200.0, child="body", parent="camera_init", w=np.sqrt(0.5))
    pose.pose.pose.orientation.z = np.sqrt(0.5)
    return write(tmp_path / "registered", [("/odom", pose, 1.0), ("/points", double_cloud(
        turned, "camera_init"), 1.0)], "MCAP")


def test_registered_clouds_are_told_from_the_sensor_of_the_odometry(registered, plane):
    (scan,) = BagDataset(registered, odometry="/odom")
    np.testing.assert_allclose(scan.points[:, :3], plane, atol=1e-5)
    turn = [[0, -1, 0, 200], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    np.testing.assert_allclose(scan.pose, turn, atol=1e-9)
    (scan,) = BagDataset(registered)
    words = ("'camera_init', in which TF or odometry places 'body': that of a map, not of the sensor; "
             "name the sensor's odometry")
    assert scan.pose is None and words in scan.pose_missing


def test_odometry_of_another_tree_is_still_refused(tmp_path):
    messages = [("/odom", odometry(1.0, 3.0), 1.0),
                ("/tf", tf(1.0, "map", "lidar", (0.0, 0.0, 0.0)), 1.0),
                ("/points", cloud(STORE, "plain", 0, 1.0), 1.0)]
    with pytest.raises(ValueError, match="expected odometry of 'lidar' or a frame above it"):
        BagDataset(write(tmp_path / "drive", messages, "MCAP"), odometry="/odom")


def run(path, out, *flags):
    return main(["run", str(path), "--output", str(out), *flags])


def test_scans_without_any_answer_are_an_error(registered, tmp_path, capsys):
    for command in (["--clouds", "pcd"], ["--single-scan"]):
        assert run(registered, tmp_path / "out", *command) == 1
        told = capsys.readouterr().err
        assert "100 % of its points are outside of the 120 m" in told
        assert re.search(r"they are from 190\.\d to 20\d\.\d m in x and from -", told)
        assert "take the cloud in the sensor's frame" in told
        assert "expected ground or obstacles, got no answer for any of 10280 points" in told
        assert not (tmp_path / "out" / "run.json").exists()
    assert run(registered, tmp_path / "out", "--odometry", "/odom") == 0
    assert "warning" not in capsys.readouterr().err
    empty = tmp_path / "empty.npy"
    np.save(empty, np.zeros((0, 3)))
    assert run(empty, tmp_path / "out") == 0
    assert "empty.npy: none of 1 scans has any point" in capsys.readouterr().err


def strip(length_m):
    """Ground, and a wall along it."""
    x, y = np.meshgrid(np.arange(0, length_m, 0.5), np.arange(-10, 10, 0.5))
    return np.stack([x.ravel(), y.ravel(), np.where(y > 9, 2.0, 0.0).ravel()], axis=1) + ORIGIN


def test_scans_larger_than_the_map_are_told_of_with_what_covers_them(tmp_path, capsys):
    path = write_las(tmp_path / "strip.las", strip(300))
    assert run(path, tmp_path / "out") == 0
    told = capsys.readouterr().err
    assert told.count("warning") == 1
    assert "strip.las: scan strip: 60 % of its points are outside of the 120 m" in told
    option = told.split("--set ")[1].split()[0]
    assert run(path, tmp_path / "out", "--set", option) == 0
    assert "warning" not in capsys.readouterr().err
    assert json.loads((tmp_path / "out" / "run.json").read_text())["counts"]["unknown"] == 0
    path = write_las(tmp_path / "strip.las", strip(1500))
    assert run(path, tmp_path / "out") == 0
    words = "split the scan into tiles of at most 1352 m, or use larger cells"
    assert words in capsys.readouterr().err


def test_millimetres_are_no_map(tmp_path, plane, capsys):
    np.save(tmp_path / "a.npy", plane * 1000)
    assert groundgrid.datasets.open(tmp_path / "a.npy")[0].pose is None
    assert run(tmp_path / "a.npy", tmp_path / "out") == 1
    told = capsys.readouterr().err
    assert re.search(r"they are from -9\d00\.0 to 9\d00\.0 m in x", told)
    assert "--set" not in told and "If these are millimetres, make them metres" in told


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_coordinates_that_are_too_coarse_are_told_of(tmp_path, utm, kind, capsys):
    np.save(tmp_path / "a.npy", utm.astype(kind))
    assert run(tmp_path / "a.npy", tmp_path / "out") == 0
    told = "steps of 0.5 m. Store 64-bit floats" in capsys.readouterr().err
    assert told == (kind is np.float32)
