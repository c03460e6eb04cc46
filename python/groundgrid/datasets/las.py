"""LAS and LAZ files."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from .las_units import las_errors, open_las, units_of
from .map_coordinates import are_of_a_map, told_from_middle
from .scan import Scan, points_of
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
    floats, as those of a map are, are told from the middle of the points, in whole metres;
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
        fields = dict(zip("xyz", places.T))
        fields |= {name: np.array(points[name]) for name in points.point_format.dimension_names
                   if name not in ("X", "Y", "Z")}
        found, pose = points_of(fields, len(places)), None
        if self._poses is None and (np.abs(places).max(initial=0.0) > FARTHEST_M
                                    or are_of_a_map(found)):
            found, pose = told_from_middle(found, fields)
        return Scan(name=path.stem, points=found, pose=pose, fields=fields)
