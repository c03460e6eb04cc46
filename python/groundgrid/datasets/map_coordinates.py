"""Coordinates of a map, such as UTM's, where those of the sensor are expected."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from .scan import points_of

# No LiDAR has most of its returns from farther away.
FARTHEST_M = 1000.0
# Of the points, to either side: stray ones do not move the middle.
STRAY_PERCENT = 1.0

Points = npt.NDArray[np.float32]
Matrix = npt.NDArray[np.float64]
Fields = Mapping[str, npt.NDArray[Any]]


def placed(fields: Fields, count: int) -> tuple[Points, Matrix | None]:
    """N x 4 points of a scan without a pose, and None; of coordinates of a map the points told from
    their middle, and the pose that leads back. Raises ValueError without x, y, z."""
    points = points_of(fields, count)
    return told_from_middle(points, fields) if are_of_a_map(points) else (points, None)


def are_of_a_map(points: Points) -> bool:
    """Whether most of the points are farther away than a sensor sees, and not all around it, as they
    would be in millimetres."""
    far = are_beyond(points[:, 0], points[:, 1], FARTHEST_M)
    # Of almost every scan, which is then looked at no further.
    if not far.any():
        return False
    seen = are_seen(points[:, :3])
    if 2 * np.count_nonzero(far & seen) <= np.count_nonzero(seen):
        return False
    low, high = bounds_of(points[seen, :2])
    return bool((low > 0).any() or (high < 0).any())


def are_seen(places: npt.NDArray[Any]) -> npt.NDArray[np.bool_]:
    """Which are finite and not 0, 0, 0, which is a ray without a return."""
    # Column by column, which takes a fifth of the time.
    x, y, z = places.T
    seen: npt.NDArray[np.bool_] = np.isfinite(x) & np.isfinite(y) & np.isfinite(z)
    seen &= (x != 0) | (y != 0) | (z != 0)
    return seen


def are_beyond(
    x: npt.NDArray[Any], y: npt.NDArray[Any], reach_m: float
) -> npt.NDArray[np.bool_]:
    """Which are outside of the square that reaches so far to each side; NaN is not."""
    outside: npt.NDArray[np.bool_] = (np.abs(x) > reach_m) | (np.abs(y) > reach_m)
    return outside


def bounds_of(places: npt.NDArray[Any]) -> npt.NDArray[np.float64]:
    """The least and the greatest coordinates, but for stray points."""
    bounds: npt.NDArray[np.float64] = np.percentile(
        places.astype(np.float64), [STRAY_PERCENT, 100 - STRAY_PERCENT], axis=0)
    return bounds


def told_from(points: Points, fields: Fields, pose: Matrix) -> Points:
    """The points in the frame whose pose in theirs this is.

    From the fields, which may have more digits than the points.
    """
    places = np.stack([np.asarray(fields[name], np.float64) for name in "xyz"], axis=1)
    seen = are_seen(places)
    points[seen, :3] = (places[seen] - pose[:3, 3]) @ pose[:3, :3]
    return points


def told_from_middle(points: Points, fields: Fields) -> tuple[Points, Matrix]:
    """The points from the middle of their bounds, in whole metres, and the pose that leads back."""
    places = np.stack([np.asarray(fields[name], np.float64) for name in "xyz"], axis=1)
    pose = np.eye(4)
    pose[:3, 3] = np.round(bounds_of(places[are_seen(places)]).mean(axis=0))
    return told_from(points, fields, pose), pose
