import numpy as np
import pytest

import groundgrid
from groundgrid.evaluation import SegmentationMetrics, to_semantic_kitti
from groundgrid.simulation import Drive, scene_names, sensor_names


def test_names_scenes_and_sensors():
    assert "urban" in scene_names() and "hill" in scene_names()
    assert sensor_names()[0] == "hdl-64e"


def test_scans_bring_their_truth(scan):
    n = len(scan.points)
    assert n > 10000
    assert scan.points.shape == (n, 4) and scan.points.dtype == np.float32
    assert scan.labels.shape == scan.heights.shape == (n,)
    assert scan.labels.dtype == np.uint32 and scan.heights.dtype == np.float32
    road = scan.labels & 0xFFFF == 40
    assert np.median(np.abs(scan.heights[road])) < 0.05
    assert scan.time_s == 0.0


def test_the_map_begins_at_the_sensor(drive):
    assert len(drive) == 3
    np.testing.assert_allclose(drive.true_poses[0][:3, 3], 0, atol=1e-12)
    np.testing.assert_array_equal(drive.poses, drive.true_poses)
    np.testing.assert_array_equal(drive[2].pose, drive.true_poses[2])
    assert drive.T_base_sensor[2, 3] == drive.sensor_height_m
    assert drive[-1].time_s == pytest.approx(0.2)
    with pytest.raises(IndexError, match="3 scans"):
        drive[3]
    with pytest.raises(IndexError):
        drive[-4]


def test_scans_are_the_same_in_any_order(drive, scan):
    drive[2]
    again = drive[0]
    np.testing.assert_array_equal(again.points, scan.points)
    other = Drive("urban", "vlp-16", scans=3, seed=4, threads=1)
    np.testing.assert_array_equal(other[0].points, scan.points)
    assert not np.array_equal(Drive("urban", "vlp-16", scans=3, seed=5)[0].points, scan.points)


def test_terrain_is_that_below_the_scans(drive, scan):
    terrain = drive.terrain
    assert terrain.height.shape == terrain.vegetation.shape == terrain.kerbs.shape
    road = scan.points[scan.labels & 0xFFFF == 40].astype(np.float64)
    place = road[:, :3] @ scan.pose[:3, :3].T + scan.pose[:3, 3]
    column = ((place[:, 0] - terrain.min_x_m) / terrain.resolution_m).astype(int)
    row = ((place[:, 1] - terrain.min_y_m) / terrain.resolution_m).astype(int)
    assert np.median(np.abs(terrain.height[row, column] - place[:, 2])) < 0.05
    assert set(np.unique(terrain.kerbs)) == {0, 1}


def test_noisy_poses_differ_from_the_true_ones():
    drive = Drive("urban", "vlp-16", scans=5, pose_noise_m=0.1)
    errors = drive.poses[:, :3, 3] - drive.true_poses[:, :3, 3]
    assert np.all(errors[0] == 0) and np.all(errors[1:] != 0)
    assert np.abs(errors).max() < 0.6


def test_options_change_the_drive():
    low = Drive("urban", "vlp-16", scans=1, sensor_height_m=0.7)
    assert low.sensor_height_m == 0.7
    distorted = Drive("motorway", "vlp-16", scans=1, motion="distorted")[0]
    corrected = Drive("motorway", "vlp-16", scans=1, motion="corrected")[0]
    assert not np.array_equal(distorted.points, corrected.points)


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ({"scene": "moon"}, ValueError, "moon"),
        ({"sensor": "radar"}, ValueError, "sensor: expected hdl-64e, .* got 'radar'"),
        ({"sensor": "nothing.toml"}, FileNotFoundError, "nothing.toml"),
        ({"scans": 0}, ValueError, "scans: expected 1 to 100000"),
        ({"scans": -3}, ValueError, "scans"),
        ({"threads": -1}, ValueError, "threads"),
        ({"motion": "slow"}, ValueError, "motion: expected 'corrected' or 'distorted', got 'slow'"),
        ({"pose_noise_m": -1.0}, ValueError, "pose_noise_m"),
        ({"pose_drift_m": float("nan")}, ValueError, "pose_drift_m"),
        ({"sensor_height_m": 9.0}, ValueError, "sensor_height_m"),
        ({"seed": -1}, TypeError, "seed"),
    ],
)
def test_other_drives_are_refused(arguments, error, words):
    with pytest.raises(error, match=words):
        Drive(**{"scans": 1, **arguments})


def test_the_method_scores_on_a_drive(drive):
    grid = groundgrid.GroundGrid(sensor_height_m=drive.sensor_height_m)
    metrics = SegmentationMetrics()
    for scan, pose in zip(drive, drive.poses):
        labels = grid.process(scan.points, pose).labels
        metrics.add_scan(scan.points, scan.labels, to_semantic_kitti(labels), scan.heights)
    assert metrics.report()["iou"] > 0.9
