"""Colours of labels and of heights."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import Label, Traversability

Colors = npt.NDArray[np.uint8]

LABELS = {
    Label.GROUND: (106, 190, 97),
    Label.OBSTACLE: (255, 140, 40),
    Label.OUTLIER: (235, 60, 160),
    Label.UNKNOWN: (120, 120, 120),
}
TRAVERSABILITY = {
    Traversability.UNKNOWN: (38, 40, 46),
    Traversability.NO: (214, 84, 60),
    Traversability.YES: (86, 168, 94),
}
NOT_KNOWN = (38, 40, 46)
PATH = (120, 190, 255)

# Even steps of lightness, as viridis has them.
STOPS = np.array([(68, 1, 84), (65, 68, 135), (42, 120, 142), (34, 168, 132), (122, 209, 81),
                  (253, 231, 37)], np.float64)


def by_value(values: npt.NDArray[Any], low: float, high: float) -> Colors:
    """RGB of each value, from dark at low to bright at high; NaN has the colour of the unknown."""
    share = (values.astype(np.float64) - low) / max(high - low, 1e-9)
    places = np.clip(np.nan_to_num(share), 0, 1) * (len(STOPS) - 1)
    colors = np.stack([np.interp(places, np.arange(len(STOPS)), STOPS[:, channel])
                       for channel in range(3)], axis=-1).astype(np.uint8)
    colors[np.isnan(values)] = NOT_KNOWN
    return colors


def by_traversability(values: npt.NDArray[np.uint8]) -> Colors:
    table = np.zeros((len(TRAVERSABILITY), 3), np.uint8)
    for value, color in TRAVERSABILITY.items():
        table[value] = color
    colors: Colors = table[values]
    return colors
