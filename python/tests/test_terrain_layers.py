"""Layers for planners, on ground whose slope and steps are known."""

import threading

import numpy as np
import pytest

import groundgrid
from groundgrid import TerrainLayers, Traversability, TraversabilityLimits


def ground(height_of):
    """Points 0.1 m apart up to 12 m, seen from 1.5 m above."""
    x, y = np.meshgrid(np.arange(-12, 12, 0.1), np.arange(-12, 12, 0.1))
    return np.stack([x.ravel(), y.ravel(), height_of(x, y).ravel() - 1.5], 1).astype(np.float32)


def mapped(points):
    grid = groundgrid.GroundGrid(sensor_height_m=1.5)
    return grid, grid.process(points)


def near(grid, x, y):
    terrain = grid.terrain
    return (int((y - terrain.min_y_m) / terrain.resolution_m),
            int((x - terrain.min_x_m) / terrain.resolution_m))


def test_a_slope_shows_as_its_angle():
    grid, _ = mapped(ground(lambda x, y: 0.1 * x))
    layers = TerrainLayers()
    assert layers.size == 0
    layers.update(grid)
    assert layers.size == grid.terrain.size and layers.slope_deg.shape == (layers.size,) * 2
    place = near(grid, 6.0, 2.0)
    (first_row, first_column), (end_row, end_column) = near(grid, 3, -3), near(grid, 9, 3)
    inner = np.s_[first_row:end_row, first_column:end_column]
    slope_deg = np.degrees(np.arctan(0.1))
    assert np.median(layers.slope_deg[inner]) == pytest.approx(slope_deg, abs=0.3)
    assert np.abs(layers.slope_deg[inner] - slope_deg).max() < 1
    assert np.median(layers.step_m[inner]) < 0.01
    assert np.median(layers.roughness_m[inner]) < 0.01
    assert layers.traversability[place] == Traversability.YES
    layers.update(grid, limits=TraversabilityLimits(max_slope_deg=5))
    assert layers.traversability[place] == Traversability.NO
    corner = layers.traversability[0, 0]
    assert corner == Traversability.UNKNOWN and np.isnan(layers.slope_deg[0, 0])


def test_obstacles_come_with_their_height(plane):
    grid, result = mapped(plane)
    layers = TerrainLayers(window_m=1.0)
    layers.update(grid, plane, labels=result.labels)
    # The wall at x = 6 m rises from 0.4 m to 1 m over the ground.
    wall = near(grid, 6.05, 0.0)
    assert layers.obstacle_height_m[wall] == pytest.approx(0.95, abs=0.06)
    assert layers.traversability[wall] == Traversability.NO
    free = near(grid, 4.0, 4.0)
    assert layers.obstacle_height_m[free] == 0
    layers.update(grid, plane, labels=result.labels,
                  limits=TraversabilityLimits(overhang_clearance_m=0.35))
    assert np.isnan(layers.obstacle_height_m[wall]) or layers.obstacle_height_m[wall] == 0


def test_layers_are_copies():
    grid, _ = mapped(ground(lambda x, y: 0 * x))
    layers = TerrainLayers()
    layers.update(grid)
    slope = layers.slope_deg
    kept = slope.copy()
    grid.process(ground(lambda x, y: 0.2 * x))
    layers.update(grid)
    np.testing.assert_array_equal(slope, kept)


def test_readers_see_one_map_or_the_other(plane):
    """While one thread makes layers of two maps in turns, another reads them."""
    tilted = plane.copy()
    tilted[:, 2] += 0.1 * tilted[:, 0]
    grids = [groundgrid.GroundGrid(sensor_height_m=1.5) for _ in range(2)]
    layers, wanted = TerrainLayers(), set()
    for grid, points in zip(grids, (plane, tilted), strict=True):
        grid.process(points)
        layers.update(grid)
        wanted.add(layers.slope_deg.tobytes())
    done = threading.Event()

    def write():
        for number in range(60):
            layers.update(grids[number % 2])
        done.set()

    writer = threading.Thread(target=write)
    writer.start()
    while not done.is_set():
        assert layers.slope_deg.tobytes() in wanted
    writer.join()


def test_wrong_input_is_refused(plane):
    grid, result = mapped(plane)
    layers = TerrainLayers()
    with pytest.raises(ValueError, match="max_step_m"):
        TraversabilityLimits(max_step_m=-1)
    with pytest.raises(ValueError, match="window"):
        TerrainLayers(0)
    with pytest.raises(ValueError, match="points and labels: expected both or neither"):
        layers.update(grid, plane)
    with pytest.raises(ValueError, match="label"):
        layers.update(grid, plane, labels=result.labels[1:])
    with pytest.raises(ValueError, match="labels: expected those of Label, 0 to 3, got 40"):
        layers.update(grid, plane, labels=np.full(len(plane), 40))
    with pytest.raises(TypeError):
        layers.update(grid, plane, labels=["ground"])
    assert layers.size == 0
    layers.update(groundgrid.GroundGrid())
    assert layers.size == 0 and layers.slope_deg.shape == (0, 0)
