"""Poses from a file in KITTI's or TUM's form, for scans of any source."""

from __future__ import annotations

import os

from .._core import read_pose_file
from .transforms import Matrix, Track


class PoseFile:
    """The pose of each scan of a recording: the k-th line is that of the k-th scan.

    Poses in TUM's form are interpolated at the scans' times where the scans have times; up to 0.1 s
    before the first and behind the last it is that one.

    Raises FileNotFoundError and ValueError, with the line, where the file cannot be read.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._path = os.fspath(path)
        self._poses, times = read_pose_file(path)
        self._track: Track | None = None
        if times is not None:
            self._track = Track()
            for time_s, pose in zip(times, self._poses):
                self._track.add_matrix(round(time_s * 1e9), pose)

    def pose(self, index: int, time_s: float | None) -> Matrix:
        """T_map_sensor. Raises ValueError where the file has none for this scan."""
        if self._track is not None and time_s is not None:
            pose = self._track.at(round(time_s * 1e9))
            if pose is None:
                raise ValueError(f"{self._path}: expected poses around {time_s:.3f} s, the time of "
                                 f"scan {index}, got none: are both of one clock?")
            return pose
        if index >= len(self._poses):
            raise ValueError(f"{self._path}: expected the pose of scan {index} in line {index + 1},"
                             f" got the end of the file after {len(self._poses)} poses")
        matrix: Matrix = self._poses[index]
        return matrix


def pose_file(path: str | os.PathLike[str] | None) -> PoseFile | None:
    return None if path is None else PoseFile(path)
