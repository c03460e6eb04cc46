"""The map's layers as images, north at the top."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import Terrain, TerrainLayers
from .colors import Colors, by_traversability, by_value
from .terrain_mesh import HEIGHT_SHARES, MIN_CONFIDENCE

# What is brightest.
MOST = {"standard_deviation": 0.5, "slope": 30.0, "step": 0.3, "obstacle_height": 2.5}
LAYERS = ("height", "confidence", "standard_deviation", "slope", "step", "obstacle_height",
          "traversability")


def images_of(terrain: Terrain, layers: TerrainLayers) -> Iterator[tuple[str, Colors]]:
    """Name and RGB of each of LAYERS, in that order."""
    known = terrain.confidence >= MIN_CONFIDENCE

    def masked(values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        return np.where(known, values, np.nan)

    heights = masked(terrain.height)
    low, high = np.nanpercentile(heights, HEIGHT_SHARES) if known.any() else (0.0, 1.0)
    yield "height", north_up(by_value(heights, low, high))
    yield "confidence", north_up(by_value(masked(terrain.confidence), 0, 1))
    for name, values in (
        ("standard_deviation", masked(terrain.standard_deviation)),
        ("slope", layers.slope_deg),
        ("step", layers.step_m),
        ("obstacle_height", layers.obstacle_height_m),
    ):
        yield name, north_up(by_value(values, 0, MOST[name]))
    yield "traversability", north_up(by_traversability(layers.traversability))


def north_up(colors: Colors) -> Colors:
    return np.ascontiguousarray(colors[::-1])
