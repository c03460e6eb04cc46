"""Scans that lie outside of the map around the sensor."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from .._core import Config, parameters
from ..datasets import Scan
from ..datasets.map_coordinates import are_beyond, are_seen, bounds_of

EXTENT = next(each for each in parameters() if each.name.endswith("extent_m"))
# Of a map; the core refuses more.
MOST_CELLS = 4096
# Coarser 32-bit floats leave points in rows and columns.
COARSEST_M = 0.01


class MapCheck:
    """Says once that most of a scan has no answer, and what to do."""

    def __init__(self, path: Path, config: Config, warn: Callable[[str], None]) -> None:
        self._path, self._warn = path, warn
        self._extent_m = float(getattr(config, EXTENT.name))
        self._largest_m = min(EXTENT.max, MOST_CELLS * config.resolution_m)
        self._told: set[str] = set()

    def add(self, scan: Scan) -> None:
        self._tell(scan, "outside", lambda: most_outside(scan, self._extent_m, self._largest_m))
        self._tell(scan, "coarse", lambda: coarse(scan))

    def _tell(self, scan: Scan, kind: str, look: Callable[[], str]) -> None:
        if kind not in self._told and (words := look()):
            self._told.add(kind)
            self._warn(f"{self._path}: scan {scan.name}: {words}")


def most_outside(scan: Scan, extent_m: float, largest_m: float) -> str:
    """Words if more than half of the points lie outside of the map; else none."""
    seen = are_seen(scan.points[:, :3])
    x, y, z = scan.points[:, :3].T
    # The axes of the map are those of the poses.
    if scan.pose is not None:
        with np.errstate(invalid="ignore", over="ignore"):
            x, y = (a * x + b * y + c * z for a, b, c in scan.pose[:2, :3].astype(np.float32))
    outside = are_beyond(x, y, extent_m / 2)[seen]
    if 2 * np.count_nonzero(outside) <= len(outside):
        return ""
    places = np.stack([x[seen], y[seen]], axis=1)
    (west, south), (east, north) = bounds_of(places)
    words = (f"{100 * outside.mean():.0f} % of its points are outside of the {extent_m:g} m around "
             f"the sensor that the map covers: they are from {west:.1f} to {east:.1f} m in x and "
             f"from {south:.1f} to {north:.1f} m in y of the sensor")
    if max(west, -east, south, -north) > 0:
        return (f"{words}. If these are coordinates of a map, take the cloud in the sensor's "
                "frame, or one whose poses or odometry say where the sensor was")
    needed_m = np.ceil(2 * np.abs(places).max()) + 1
    if needed_m > largest_m:
        return (f"{words}. If these are millimetres, make them metres; else split the scan into "
                f"tiles of at most {largest_m:.0f} m, or use larger cells")
    return f"{words}. --set {EXTENT.name}={needed_m:.0f} covers all"


def coarse(scan: Scan) -> str:
    """Words if the numbers of the source are too coarse for where they are; else none."""
    # As far away the sensor is if the numbers are.
    if scan.pose is None or np.spacing(np.float32(np.abs(scan.pose[:2, 3]).max())) <= COARSEST_M:
        return ""
    numbers = [scan.fields[name] for name in "xy"]
    if not len(numbers[0]) or any(each.dtype != np.float32 for each in numbers):
        return ""
    step_m = max(float(np.spacing(np.nanmedian(np.abs(each)))) for each in numbers)
    if not step_m > COARSEST_M:
        return ""
    return (f"its coordinates are 32-bit floats so large that they have steps of {step_m:g} m. "
            "Store 64-bit floats, or coordinates from a place nearby")
