"""Poses, mountings, several sensors and motion within a scan."""

import numpy as np
import pytest
from transforms import translation

from groundgrid import GroundGrid, Label, SensorScan


@pytest.mark.parametrize(
    ("pose", "error", "words"),
    [
        (np.eye(3), ValueError, r"pose: expected 4 × 4 or 3 × 4 numbers, got float64 .*\(3, 3\)"),
        (np.zeros((4, 4)), ValueError, "pose: its last row must be 0 0 0 1"),
        (np.zeros((3, 4)), ValueError, "T_map_base.* is not rigid"),
        (np.full((3, 4), np.nan), ValueError, "T_map_base.* NaN"),
        (np.diag([1.0, 1.0, -1.0, 1.0]), ValueError, "not rigid"),
        (np.eye(4) + 0.5j, TypeError, "pose"),
        (translation(x=1e12), ValueError, "1e9 m"),
        ("north", TypeError, "pose: expected an array of 4 × 4 numbers, got str"),
        ([[1, 2], [3]], TypeError, "pose"),
    ],
)
def test_other_poses_are_refused(plane, pose, error, words):
    with pytest.raises(error, match=words):
        GroundGrid().process(plane, pose)
    with pytest.raises(error):
        GroundGrid().process(plane, mounting=pose)


def test_poses_of_any_layout_are_the_same(plane):
    pose = translation(3.0, 2.0, 1.0)
    expected = GroundGrid(sensor_height_m=1.5).process(plane, pose)
    for same in (pose[:3], pose.tolist(), np.asfortranarray(pose), pose.astype(np.float32)):
        result = GroundGrid(sensor_height_m=1.5).process(plane, same)
        np.testing.assert_array_equal(result.labels, expected.labels)


def test_mounting_lifts_the_sensor(plane):
    grid = GroundGrid()
    result = grid.process(plane, mounting=translation(z=1.5))
    assert result.sensor_height_m == 1.5 and not result.sensor_height_estimated
    assert result.ground > result.obstacle


def test_a_jump_restarts_the_map(plane):
    grid = GroundGrid(sensor_height_m=1.5)
    assert not grid.process(plane).map_restarted
    assert not grid.process(plane, translation(x=1.0)).map_restarted
    assert grid.process(plane, translation(x=100.0)).map_restarted


def test_several_sensors_are_one_scan(plane):
    half = len(plane) // 2
    scans = [
        SensorScan(plane[:half], translation(z=1.5)),
        SensorScan(plane[half:].astype(np.float64), mounting=translation(z=1.5)),
    ]
    both = GroundGrid().process_scans(scans)
    one = GroundGrid().process(plane, mounting=translation(z=1.5))
    np.testing.assert_array_equal(both.labels, one.labels)
    assert len(GroundGrid().process_scans([]).labels) == 0
    with pytest.raises(TypeError):
        GroundGrid().process_scans([plane])
    with pytest.raises(TypeError, match="points: expected a NumPy array, got int"):
        GroundGrid().process_scans([SensorScan(3)])


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.uint32])
def test_corrects_the_motion_within_a_scan(plane, dtype):
    # The vehicle moves 1 m along x; the sensor saw each point at its own time from its own place.
    share = np.linspace(0, 1, len(plane))
    times = (share * 1000).astype(dtype)
    seen = plane.copy()
    seen[:, 0] += (1 - times.astype(np.float64) / 1000).astype(np.float32)
    grid = GroundGrid(sensor_height_m=1.5)
    result = grid.process(
        seen, translation(x=1.0), times=times, time_span=(0, 1000), pose_begin=translation()
    )
    wall = plane[:, 2] > -1.4
    assert np.mean(result.labels[wall] == Label.OBSTACLE) > 0.99
    x = grid.terrain.x_m
    highest = np.nanmax(np.where(np.isnan(grid.terrain.highest), -9, grid.terrain.highest), axis=0)
    # All of the wall is where it stands: 6 m before the pose at the end.
    assert set(np.flatnonzero(highest > -1.2)) <= set(np.flatnonzero(np.abs(x - 7.0) < 0.34))


def test_times_must_be_whole(plane):
    n = len(plane)
    begin = translation()
    for arguments, error, words in [
        ({"times": np.zeros(n)}, ValueError, "together with time_span"),
        ({"time_span": (0, 1)}, ValueError, "together with time_span"),
        ({"times": np.zeros(n), "time_span": 3, "pose_begin": begin}, TypeError, "two numbers"),
        ({"times": np.zeros(n), "time_span": (0, 1)}, ValueError, "together with pose_begin"),
        ({"times": np.zeros(n - 1), "time_span": (0, 1)}, ValueError, f"{n} times"),
        ({"times": np.zeros(n, np.int64), "time_span": (0, 1)}, TypeError, "uint32"),
        ({"times": np.zeros(n), "time_span": (1, 1), "pose_begin": begin}, ValueError, "later"),
        ({"pose_begin": translation(x=500.0)}, ValueError, "more than 20 m apart"),
    ]:
        with pytest.raises(error, match=words):
            GroundGrid().process(plane, **arguments)
