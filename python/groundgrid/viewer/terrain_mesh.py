"""The map as a shaded surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .._core import Terrain
from .colors import Colors, by_value

# Less is extrapolated and hides what is below.
MIN_CONFIDENCE = 0.05
# Gaps up to twice as wide are closed with the heights that the map has there.
CLOSED_M = 2.0
LIGHT = np.array([-0.45, 0.35, 0.82])
# The middle of the heights has all the colours.
HEIGHT_SHARES = (2, 98)


@dataclass(frozen=True)
class TerrainMesh:
    """Triangles between the middles of cells that are known."""

    vertices: npt.NDArray[np.float32]
    """V x 3, metres, relative to the origin."""
    triangles: npt.NDArray[np.uint32]
    """T x 3, vertices counter-clockwise from above."""
    normals: npt.NDArray[np.float32]
    colors: Colors


def mesh_of(terrain: Terrain, origin: npt.NDArray[np.float64]) -> TerrainMesh:
    """Of the cells with enough confidence; without vertices where there is none."""
    known = closed(terrain.confidence >= MIN_CONFIDENCE, round(CLOSED_M / terrain.resolution_m))
    heights = np.where(known, terrain.height, np.nan)
    corners = [known[:-1, :-1], known[:-1, 1:], known[1:, 1:], known[1:, :-1]]
    squares = np.argwhere(np.logical_and.reduce(corners))
    if not len(squares):
        return empty_mesh()
    side = terrain.size
    first = squares[:, 0] * side + squares[:, 1]
    a, b, c, d = first, first + 1, first + side + 1, first + side
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    used, places = np.unique(triangles, return_inverse=True)
    x, y = np.meshgrid(terrain.x_m, terrain.y_m)
    vertices = np.stack([x.ravel()[used], y.ravel()[used], terrain.height.ravel()[used]], 1)
    normals = normals_of(heights, terrain.resolution_m).reshape(-1, 3)[used]
    return TerrainMesh(
        (vertices - origin).astype(np.float32),
        places.reshape(-1, 3).astype(np.uint32),
        normals.astype(np.float32),
        shaded(terrain.height.ravel()[used], normals),
    )


def closed(known: npt.NDArray[np.bool_], reach: int) -> npt.NDArray[np.bool_]:
    """With the gaps that a square reaching so many cells to each side does not fit into."""
    grown = np.pad(known, reach)
    grown = spread(spread(grown, reach).T, reach).T
    shrunk = ~spread(spread(~grown, reach).T, reach).T
    inner = slice(reach, len(grown) - reach)
    return shrunk[inner, inner]


def spread(cells: npt.NDArray[np.bool_], reach: int) -> npt.NDArray[np.bool_]:
    """Along each row, so many cells to both sides."""
    sums = np.cumsum(np.pad(cells, ((0, 0), (reach + 1, reach))), axis=1)
    found: npt.NDArray[np.bool_] = sums[:, 2 * reach + 1 :] > sums[:, : -(2 * reach + 1)]
    return found


def normals_of(
    heights: npt.NDArray[np.float64], resolution_m: float
) -> npt.NDArray[np.float64]:
    along_y, along_x = np.gradient(heights, resolution_m)
    normals = np.stack([-along_x, -along_y, np.ones_like(heights)], axis=-1)
    # At the edge of what is known there is no slope to tell.
    normals[np.isnan(normals).any(axis=-1)] = (0, 0, 1)
    unit: npt.NDArray[np.float64] = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
    return unit


def shaded(heights: npt.NDArray[np.float64], normals: npt.NDArray[np.float64]) -> Colors:
    low, high = np.percentile(heights, HEIGHT_SHARES)
    light = np.clip(normals @ (LIGHT / np.linalg.norm(LIGHT)), 0.2, 1)
    colors: Colors = (by_value(heights, low, high) * (0.25 + 0.65 * light[:, None])).astype(np.uint8)
    return colors


def empty_mesh() -> TerrainMesh:
    return TerrainMesh(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32),
                       np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint8))
