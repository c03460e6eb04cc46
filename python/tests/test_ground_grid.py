import gc
import threading
import time
import weakref

import numpy as np
import pytest

import groundgrid
from groundgrid import Config, GroundGrid, Label, SensorScan


def transform(x=0.0, y=0.0, z=0.0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


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


def layouts(points):
    """The same points, laid out in memory in every way there is."""
    n = len(points)
    wide = np.zeros((n, 7), np.float32)
    wide[:, 2:5] = points
    reversed_columns = np.ascontiguousarray(points[:, ::-1])
    records = np.zeros(n, np.dtype([("ring", "u1"), ("xyz", "f4", 3), ("t", "u2")]))
    records["xyz"] = points
    every_other = np.zeros((2 * n, 4), np.float32)
    every_other[::2, :3] = points
    read_only = points.copy()
    read_only.flags.writeable = False
    big = np.zeros((n, 3, 2), np.float32)
    big[:, :, 1] = points
    return {
        "contiguous": points,
        "four columns": np.column_stack([points, np.ones(n, np.float32)]),
        "inner columns": wide[:, 2:5],
        "column-major": np.asfortranarray(points),
        "reversed rows": np.ascontiguousarray(points[::-1])[::-1],
        "reversed columns": reversed_columns[:, ::-1],
        "records with odd strides": records["xyz"],
        "every other row": every_other[::2, :3],
        "read-only": read_only,
        "gaps between columns": big[:, :, 1],
        "float64": points.astype(np.float64),
        "big-endian": points.astype(">f4"),
        "big-endian float64": points.astype(">f8"),
        "memoryview": memoryview(points),
    }


LAYOUTS = list(layouts(np.zeros((1, 3), np.float32)))


@pytest.mark.parametrize("name", LAYOUTS)
def test_any_layout_gives_the_same(plane, name):
    expected = GroundGrid(sensor_height_m=1.5).process(plane)
    array = layouts(plane)[name]
    before = np.array(array)
    result = GroundGrid(sensor_height_m=1.5).process(array)
    np.testing.assert_array_equal(result.labels, expected.labels)
    np.testing.assert_array_equal(result.height_above_ground, expected.height_above_ground)
    np.testing.assert_array_equal(np.array(array), before)


class WithArray:
    def __init__(self, array):
        self.array = array

    def __array__(self, dtype=None, copy=None):
        return self.array


def test_takes_what_gives_an_array(plane):
    expected = GroundGrid(sensor_height_m=1.5).process(plane)
    result = GroundGrid(sensor_height_m=1.5).process(WithArray(plane))
    np.testing.assert_array_equal(result.labels, expected.labels)


@pytest.mark.parametrize(
    ("points", "error", "words"),
    [
        (None, TypeError, "points: expected a NumPy array, got NoneType"),
        ([[0.0, 1.0, 2.0]], TypeError, "points: expected a NumPy array, got list"),
        ("points", TypeError, "points: expected a NumPy array, got str"),
        (b"points", TypeError, "points: expected an array of float32 or float64"),
        (np.zeros((4, 3), np.int32), TypeError, r"got int32 array of shape \(4, 3\)"),
        (np.zeros((4, 3), np.float16), TypeError, "got float16"),
        (np.zeros((4, 3), np.complex64), TypeError, "got complex64"),
        (np.zeros((4, 3), object), TypeError, "points"),
        (np.zeros(4, [("x", "f4"), ("y", "f4")]), TypeError, "points"),
        (np.zeros((4, 3), "M8[s]"), TypeError, "points"),
        (np.float32(1), (TypeError, ValueError), "points"),
        (np.zeros(3, np.float32), ValueError, r"x, y, z first, got float32 array of shape \(3,\)"),
        (np.zeros((4, 2), np.float32), ValueError, r"\(4, 2\)"),
        (np.zeros((4, 3, 1), np.float32), ValueError, r"\(4, 3, 1\)"),
        (np.broadcast_to(np.zeros(3), (2**40, 3)), ValueError, "more than 4194304"),
    ],
)
def test_other_points_are_refused(points, error, words):
    with pytest.raises(error, match=words):
        GroundGrid().process(points)


@pytest.mark.parametrize("shape", [(0, 3), (0, 7), (1, 3), (2, 3)])
def test_takes_few_points(shape):
    grid = GroundGrid(sensor_height_m=1.5)
    for points in (np.ones(shape, np.float32), np.ones(shape), np.asfortranarray(np.ones(shape))):
        result = grid.process(points)
        assert len(result.labels) == len(result.height_above_ground) == shape[0]


def test_takes_broadcast_points():
    points = np.broadcast_to(np.array([3.0, 0.0, -1.5], np.float32), (100, 3))
    result = GroundGrid(sensor_height_m=1.5).process(points)
    assert result.ground + result.obstacle == 100
    result = GroundGrid(sensor_height_m=1.5).process(np.broadcast_to(np.float32(1), (100, 3)))
    assert len(result.labels) == 100


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


@pytest.mark.parametrize(
    ("pose", "error", "words"),
    [
        (np.eye(3), ValueError, r"pose: expected 4 × 4 or 3 × 4 numbers, got float64 .*\(3, 3\)"),
        (np.zeros((4, 4)), ValueError, "pose: its last row must be 0 0 0 1"),
        (np.zeros((3, 4)), ValueError, "T_map_base.* is not rigid"),
        (np.full((3, 4), np.nan), ValueError, "T_map_base.* NaN"),
        (np.diag([1.0, 1.0, -1.0, 1.0]), ValueError, "not rigid"),
        (np.eye(4) + 0.5j, TypeError, "pose"),
        (transform(x=1e12), ValueError, "1e9 m"),
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
    pose = transform(3.0, 2.0, 1.0)
    expected = GroundGrid(sensor_height_m=1.5).process(plane, pose)
    for same in (pose[:3], pose.tolist(), np.asfortranarray(pose), pose.astype(np.float32)):
        result = GroundGrid(sensor_height_m=1.5).process(plane, same)
        np.testing.assert_array_equal(result.labels, expected.labels)


def test_mounting_lifts_the_sensor(plane):
    grid = GroundGrid()
    result = grid.process(plane, mounting=transform(z=1.5))
    assert result.sensor_height_m == 1.5 and not result.sensor_height_estimated
    assert result.ground > result.obstacle


def test_estimates_the_height_of_the_sensor(plane):
    result = GroundGrid().process(plane)
    assert result.sensor_height_estimated
    assert result.sensor_height_m == pytest.approx(1.5, abs=0.02)
    assert groundgrid.estimate_sensor_height(plane) == pytest.approx(1.5, abs=0.02)
    assert groundgrid.estimate_sensor_height(np.zeros((0, 3))) is None
    assert groundgrid.estimate_sensor_height(plane, Config(min_range_m=50.0)) is None


def test_a_jump_restarts_the_map(plane):
    grid = GroundGrid(sensor_height_m=1.5)
    assert not grid.process(plane).map_restarted
    assert not grid.process(plane, transform(x=1.0)).map_restarted
    assert grid.process(plane, transform(x=100.0)).map_restarted


def test_several_sensors_are_one_scan(plane):
    half = len(plane) // 2
    scans = [
        SensorScan(plane[:half], transform(z=1.5)),
        SensorScan(plane[half:].astype(np.float64), mounting=transform(z=1.5)),
    ]
    both = GroundGrid().process_scans(scans)
    one = GroundGrid().process(plane, mounting=transform(z=1.5))
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
        seen, transform(x=1.0), times=times, time_span=(0, 1000), pose_begin=transform()
    )
    wall = plane[:, 2] > -1.4
    assert np.mean(result.labels[wall] == Label.OBSTACLE) > 0.99
    x = grid.terrain.x_m
    highest = np.nanmax(np.where(np.isnan(grid.terrain.highest), -9, grid.terrain.highest), axis=0)
    # All of the wall is where it stands: 6 m before the pose at the end.
    assert set(np.flatnonzero(highest > -1.2)) <= set(np.flatnonzero(np.abs(x - 7.0) < 0.34))


def test_times_must_be_whole(plane):
    n = len(plane)
    begin = transform()
    for arguments, error, words in [
        ({"times": np.zeros(n)}, ValueError, "together with time_span"),
        ({"time_span": (0, 1)}, ValueError, "together with time_span"),
        ({"times": np.zeros(n), "time_span": 3, "pose_begin": begin}, TypeError, "two numbers"),
        ({"times": np.zeros(n), "time_span": (0, 1)}, ValueError, "together with pose_begin"),
        ({"times": np.zeros(n - 1), "time_span": (0, 1)}, ValueError, f"{n} times"),
        ({"times": np.zeros(n, np.int64), "time_span": (0, 1)}, TypeError, "uint32"),
        ({"times": np.zeros(n), "time_span": (1, 1), "pose_begin": begin}, ValueError, "later"),
        ({"pose_begin": transform(x=500.0)}, ValueError, "further apart"),
    ]:
        with pytest.raises(error, match=words):
            GroundGrid().process(plane, **arguments)


def test_terrain_has_layers_with_their_geometry(plane):
    grid = GroundGrid(sensor_height_m=1.5, map_extent_m=30.0, cell_size_m=0.5)
    assert grid.terrain.size == 0 and grid.terrain.height.shape == (0, 0)
    grid.process(plane, transform(x=100.0, y=-50.0, z=7.0))
    terrain = grid.terrain
    shape = (terrain.size, terrain.size)
    for layer, dtype in [
        (terrain.height, np.float64),
        (terrain.standard_deviation, np.float32),
        (terrain.confidence, np.float32),
        (terrain.variance, np.float32),
        (terrain.lowest, np.float64),
        (terrain.highest, np.float64),
        (terrain.points, np.uint32),
    ]:
        assert layer.shape == shape and layer.dtype == dtype
    assert terrain.cell_size_m == 0.5
    assert terrain.points.sum() == len(plane)
    assert terrain.extent_m == (
        terrain.min_x_m,
        terrain.min_x_m + terrain.size * 0.5,
        terrain.min_y_m,
        terrain.min_y_m + terrain.size * 0.5,
    )
    np.testing.assert_allclose(terrain.x_m, terrain.min_x_m + 0.5 * (np.arange(terrain.size) + 0.5))
    np.testing.assert_allclose(terrain.y_m, terrain.min_y_m + 0.5 * (np.arange(terrain.size) + 0.5))
    # The wall stands at x = 106 m, y = -52 to -48 m: columns are x.
    tall = np.argwhere(terrain.highest > 5.95)
    np.testing.assert_allclose(terrain.x_m[tall[:, 1]], 106.0, atol=0.5)
    np.testing.assert_allclose(terrain.y_m[tall[:, 0]], -50.0, atol=2.5)
    seen = terrain.highest < 5.6
    assert seen.sum() > 1400
    np.testing.assert_allclose(terrain.height[seen], 5.5, atol=0.01)
    assert np.all(terrain.standard_deviation > 0)
    assert np.median(terrain.standard_deviation[seen]) < terrain.standard_deviation[0, 0]


def test_terrain_is_a_copy(plane):
    grid = GroundGrid(sensor_height_m=1.5)
    grid.process(plane)
    terrain = grid.terrain
    before = terrain.height.copy()
    terrain.confidence[:] = 7
    grid.process(plane + np.float32([0, 0, 0.5]), transform(x=3.0))
    np.testing.assert_array_equal(terrain.height, before)
    assert grid.terrain.confidence.max() <= 1
    grid.reset()
    assert grid.terrain.size == 0


def test_config_of_a_grid_is_a_copy():
    grid = GroundGrid(Config.paper(), threads=2)
    config = grid.config
    assert config == Config.paper().replace(threads=2)
    config.threads = 5
    assert grid.config.threads == 2
    with pytest.raises(AttributeError):
        grid.config = config


def test_arrays_are_let_go(plane):
    class Array(np.ndarray):
        pass

    points = plane.copy().view(Array)
    gone = weakref.ref(points)
    grid = GroundGrid(sensor_height_m=1.5)
    result = grid.process(points)
    del points
    gc.collect()
    assert gone() is None
    assert len(result.labels) == len(plane)


def test_threads_take_turns(plane):
    """Several threads on one grid, others on grids of their own: no crash, and the same results."""
    shared = GroundGrid(sensor_height_m=1.5)
    expected = GroundGrid(sensor_height_m=1.5).process(plane).labels
    different = []

    def work(grid):
        for _ in range(20):
            labels = grid.process(plane).labels
            grid.terrain
            if len(labels) != len(expected):
                different.append(labels)

    grids = [shared] * 3 + [GroundGrid(sensor_height_m=1.5) for _ in range(2)]
    threads = [threading.Thread(target=work, args=(grid,)) for grid in grids]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not different


def test_other_threads_run_meanwhile():
    """While a call is at work, this thread counts on: it would stand still without the GIL."""
    points = np.random.default_rng(0).uniform(-50, 50, (4_000_000, 3)).astype(np.float32)
    grid = GroundGrid(sensor_height_m=1.5)
    done = threading.Event()

    def work():
        grid.process(points)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    longest, last = 0.0, time.perf_counter()
    begin = last
    while not done.is_set():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    thread.join()
    # Were the GIL held, all of the call would be one pause.
    assert longest < 0.5 * (last - begin)


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
