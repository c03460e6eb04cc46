"""The map as arrays."""

import numpy as np
from transforms import translation

from groundgrid import GroundGrid


def test_terrain_has_layers_with_their_geometry(plane):
    grid = GroundGrid(sensor_height_m=1.5, extent_m=30.0, resolution_m=0.5)
    assert grid.terrain.size == 0 and grid.terrain.height.shape == (0, 0)
    grid.process(plane, translation(x=100.0, y=-50.0, z=7.0))
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
    assert terrain.resolution_m == 0.5
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
    grid.process(plane + np.float32([0, 0, 0.5]), translation(x=3.0))
    np.testing.assert_array_equal(terrain.height, before)
    assert grid.terrain.confidence.max() <= 1
    grid.reset()
    assert grid.terrain.size == 0
