"""What GroundGrid says of a scan."""

import gc

import numpy as np
import pytest

import groundgrid
from groundgrid import Config, GroundGrid, Label


def test_tells_ground_from_wall(plane):
    result = GroundGrid(sensor_height_m=1.5).process(plane)
    ground = plane[:, 2] < -1.4
    assert np.mean(result.labels[ground] == Label.GROUND) > 0.99
    assert np.mean(result.labels[~ground] == Label.OBSTACLE) > 0.99
    # Exact where nothing but the plane is near; the wall's points are 0.4 m above it and more.
    assert np.median(np.abs(result.height_above_ground[ground])) < 0.01
    assert np.all(result.height_above_ground[~ground] > 0.35)


def test_results_are_arrays_of_their_own(plane):
    grid = GroundGrid(sensor_height_m=1.5)
    first = grid.process(plane)
    labels, heights = first
    assert labels.dtype == np.uint8 and heights.dtype == np.float32
    assert labels.shape == heights.shape == (len(plane),)
    assert labels is first.labels and heights is first.height_above_ground
    before = labels.copy(), heights.copy()
    second = grid.process(plane[::-1] + np.float32(0.3))
    np.testing.assert_array_equal(labels, before[0])
    np.testing.assert_array_equal(heights, before[1])
    assert not np.shares_memory(labels, second.labels)
    del grid, first, second
    gc.collect()
    np.testing.assert_array_equal(labels, before[0])


def test_counts_are_those_of_the_labels(plane):
    plane[:7] = np.nan
    result = GroundGrid(sensor_height_m=1.5).process(plane)
    counts = np.bincount(result.labels, minlength=4)
    assert counts[Label.UNKNOWN] == result.unknown >= 7
    assert counts[Label.GROUND] == result.ground
    assert counts[Label.OBSTACLE] == result.obstacle
    assert counts[Label.OUTLIER] == result.outlier
    assert np.all(np.isnan(result.height_above_ground[:7]))
    assert repr(result) == (
        f"ScanResult(ground={result.ground}, obstacle={result.obstacle}, "
        f"outlier={result.outlier}, unknown={result.unknown})"
    )


def test_estimates_the_height_of_the_sensor(plane):
    result = GroundGrid().process(plane)
    assert result.sensor_height_estimated
    assert result.sensor_height_m == pytest.approx(1.5, abs=0.02)
    assert groundgrid.estimate_sensor_height(plane) == pytest.approx(1.5, abs=0.02)
    assert groundgrid.estimate_sensor_height(np.zeros((0, 3))) is None
    assert groundgrid.estimate_sensor_height(plane, Config(min_range_m=50.0)) is None


def test_config_of_a_grid_is_a_copy():
    grid = GroundGrid(Config.paper(), min_range_m=2.0, threads=2)
    config = grid.config
    assert config == Config.paper().replace(min_range_m=2.0)
    config.min_range_m = 5.0
    assert grid.config.min_range_m == 2.0
    with pytest.raises(AttributeError):
        grid.config = config


def test_real_scans(real_data):
    folder = real_data / "semantickitti" / "sequences" / "00"
    metrics = groundgrid.evaluation.SegmentationMetrics()
    grid = GroundGrid()
    for scan in sorted((folder / "velodyne").glob("*.bin"))[:3]:
        points = np.fromfile(scan, np.float32).reshape(-1, 4)
        truth = np.fromfile(folder / "labels" / (scan.stem + ".label"), np.uint32)
        grid.reset()
        labels = grid.process(points).labels
        metrics.add_scan(points, truth, groundgrid.evaluation.to_semantic_kitti(labels))
    assert metrics.report(leave_unanswered_out=True)["iou"] > 0.98
