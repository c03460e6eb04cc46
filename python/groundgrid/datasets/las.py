"""LAS and LAZ files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .extras import require
from .las_units import las_errors, open_las, units_of
from .scan import Scan
from .scan_files import ScanFiles, find_scans

ENDINGS = frozenset({".las", ".laz"})
# Beyond this 32-bit floats have steps of a millimetre and more.
FARTHEST_M = 8192.0


class LasDataset(ScanFiles):
    """A LAS or LAZ file, or a folder of them, one scan a file.

    poses: poses of the sensor in KITTI's or TUM's form, one a file; coordinates are then those of
    the sensor's frame.

    Coordinates in feet, by the file's reference system, become metres; heights whose unit it does
    not tell are taken to have that of x and y. Those too large for 32-bit
    floats, as those of a map are, are told from the middle of the file's bounds, in whole metres;
    the pose is then the way back. Fields have the names of laspy: classification, gps_time, ...

    Raises FileNotFoundError and ValueError, with the file, and ImportError where laspy is missing.
    """

    def __init__(
        self, path: str | os.PathLike[str], *, poses: str | os.PathLike[str] | None = None
    ) -> None:
        super().__init__(find_scans(Path(path), ENDINGS), poses)

    def _read(self, path: Path) -> Scan:
        with open_las(path) as reader, las_errors(path):
            units = units_of(reader.header)
            points = reader.read_points(-1)
            if len(points) != reader.header.point_count:
                raise ValueError(f"the end of the file after {len(points)} points of "
                                 f"{reader.header.point_count}")
        vertical_m = units.vertical_m or units.horizontal_m
        places = np.stack([points.x, points.y, points.z], axis=1)
        places *= [units.horizontal_m, units.horizontal_m, vertical_m]
        origin = np.zeros(3)
        if len(places) and np.abs(places).max() > FARTHEST_M:
            origin = np.round((places.min(axis=0) + places.max(axis=0)) / 2)
        fields = dict(zip("xyz", places.T))
        fields |= {name: np.array(points[name]) for name in points.point_format.dimension_names
                   if name not in ("X", "Y", "Z")}
        return Scan(
            name=path.stem,
            points=shifted(places, origin, fields.get("intensity")),
            pose=translation(origin) if origin.any() else None,
            fields=fields,
        )


def shifted(
    places: npt.NDArray[np.float64],
    origin: npt.NDArray[np.float64],
    intensity: npt.NDArray[Any] | None,
) -> npt.NDArray[np.float32]:
    points = np.zeros((len(places), 4), np.float32)
    points[:, :3] = places - origin
    if intensity is not None:
        points[:, 3] = intensity
    return points


def translation(origin: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    pose = np.eye(4)
    pose[:3, 3] = origin
    return pose
