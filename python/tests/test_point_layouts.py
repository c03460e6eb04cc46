"""Points in any type and layout, and those that are refused."""

import gc
import weakref

import numpy as np
import pytest

from groundgrid import GroundGrid


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
        (np.zeros((4, 5000), np.float32), ValueError, r"over as points.T, got .* \(4, 5000\)"),
        (np.zeros((3, 17)), ValueError, r"handed over as points.T, got .* \(3, 17\)"),
        (np.zeros((64, 1024), np.float32), ValueError, r"handed over as points.T"),
        (np.broadcast_to(np.zeros(3), (2**40, 3)), ValueError, "more than 4194304"),
    ],
)
def test_other_points_are_refused(points, error, words):
    with pytest.raises(error, match=words):
        GroundGrid().process(points)


@pytest.mark.parametrize("shape", [(0, 3), (0, 7), (0, 99), (1, 3), (2, 3), (3, 16), (20, 20)])
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
