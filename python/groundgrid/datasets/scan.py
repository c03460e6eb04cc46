"""What every loader gives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True)
class Scan:
    """One scan of one sensor."""

    name: str
    """The file's name without its ending, or the number of the message."""

    points: npt.NDArray[np.float32]
    """N x 4: x, y, z in metres in the sensor's frame, and intensity (0 where there is none)."""

    pose: npt.NDArray[np.float64] | None = None
    """T_map_sensor, 4 x 4; None where it is not known."""

    time_s: float | None = None
    """When it was taken, seconds; None where it is not known."""

    labels: npt.NDArray[np.uint32] | None = None
    """True labels of SemanticKITTI; None where there are none."""

    fields: Mapping[str, npt.NDArray[Any]] = field(default_factory=dict)
    """Every number of the points as the source has it, by name: "ring", "t", ..."""

    pose_missing: str | None = None
    """Why a source that has poses has none for this scan; None where it has, or has no poses."""

    def at(self, pose: npt.NDArray[np.float64] | None) -> Scan:
        """The same scan with another pose."""
        return replace(self, pose=pose, pose_missing=None)


def points_of(fields: Mapping[str, npt.NDArray[Any]], count: int) -> npt.NDArray[np.float32]:
    """N x 4 points from x, y, z and, where it is there, intensity. Raises ValueError without x."""
    missing = [name for name in ("x", "y", "z") if name not in fields]
    if missing:
        raise ValueError(f"expected fields x, y, z, got none named {', '.join(missing)}")
    points = np.zeros((count, 4), np.float32)
    for column, name in enumerate(("x", "y", "z", "intensity")):
        if name in fields:
            points[:, column] = fields[name]
    return points
