"""KITTI, SemanticKITTI, KITTI-360 and nuScenes, PCD, PLY and text: scans that are files."""

from __future__ import annotations

import os
import pathlib
import warnings
from collections.abc import Iterator, Sequence

import numpy as np

from .._core import find_sequences, read_labels, read_poses, read_records
from .map_coordinates import placed
from .scan import Scan, points_of

Path = str | os.PathLike[str]


class FileDataset:
    """The scans of one sequence: of a dataset in KITTI's layout, a folder, a list or one file.

    sequence: the name of one of a dataset's sequences; the only one where it is left out.
    poses: poses of the LiDAR in any form that the program reads, instead of the sequence's own.
    calibration: a calib.txt whose Tr makes LiDAR poses of camera poses, or KITTI-360's folder.
    format: "kitti", "nuscenes", "pcd", "ply", "text" or the letters of a .bin file's numbers ("xyzirt")
        where neither the files' endings nor their numbers tell.

    Raises FileNotFoundError and ValueError, with the file, the place in it and what to do.
    """

    def __init__(
        self,
        path: Path,
        *,
        sequence: str | None = None,
        poses: Path | None = None,
        calibration: Path | None = None,
        format: str | None = None,
    ) -> None:
        if calibration is not None and poses is None:
            raise ValueError("calibration: expected together with poses, which it makes the LiDAR's")
        found = find_sequences(path, [] if sequence is None else [sequence], format)
        if len(found) > 1:
            names = ", ".join(each.name for each in found)
            raise ValueError(f"{os.fspath(path)}: choose one by sequence=: {names}")
        self._sequence = found[0]
        for layout in {scan.unusual_layout for scan in self._sequence.scans} - {""}:
            warnings.warn(
                f"{os.fspath(path)}: .bin files are read as {layout}, as their numbers tell; format= "
                "says otherwise",
                stacklevel=2,
            )
        self._poses = read_poses(self._sequence, poses, calibration)

    @property
    def files(self) -> list[pathlib.Path]:
        """One a scan, in their order."""
        return [pathlib.Path(scan.path) for scan in self._sequence.scans]

    @property
    def beside(self) -> list[pathlib.Path]:
        """Those of a dataset beside the scans, whether or not they are there: poses, calibration,
        times, labels."""
        return [pathlib.Path(file) for file in self._sequence.beside]

    @property
    def name(self) -> str:
        """Of the sequence; empty outside of a dataset."""
        return self._sequence.name

    def __len__(self) -> int:
        return len(self._sequence.scans)

    def __getitem__(self, index: int) -> Scan:
        file = self._sequence.scans[index]
        records, layout = read_records(file)
        dtype = np.dtype(
            {
                "names": [name for name, _, _, _ in layout],
                "formats": [(type, (count,)) if count > 1 else type for _, type, _, count in layout],
                "offsets": [offset for _, _, offset, _ in layout],
                "itemsize": records.shape[1],
            }
        )
        table = records.view(dtype)[:, 0]
        fields = {name: table[name] for name, _, _, _ in layout}
        if self._poses is None:
            points, pose = placed(fields, len(table))
        else:
            points, pose = points_of(fields, len(table)), self._poses[index]
            pose = None if np.isnan(pose).any() else pose
        return Scan(
            name=file.name,
            points=points,
            pose=pose,
            labels=read_labels(self._sequence, file, len(table)),
            fields=fields,
        )

    def __iter__(self) -> Iterator[Scan]:
        return (self[index] for index in range(len(self)))


def sequence_names(path: Path) -> Sequence[str]:
    """The sequences of a dataset; one empty name for scans outside of one."""
    return [sequence.name for sequence in find_sequences(path, [], None)]
