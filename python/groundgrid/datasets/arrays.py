"""NumPy's own files: .npy and .npz."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .scan import Scan, points_of
from .scan_files import ScanFiles, find_scans

ENDINGS = frozenset({".npy", ".npz"})
COLUMNS = ("x", "y", "z", "intensity")
Fields = dict[str, npt.NDArray[Any]]


class ArrayDataset(ScanFiles):
    """A .npy or .npz file, or a folder of them, one scan a file.

    poses: poses of the sensor in KITTI's or TUM's form, one a file.

    A .npy file holds N x 3 or more numbers, x, y, z and intensity first, or N records with fields x,
    y, z. A .npz file holds the same under the name points, or arrays x, y, z of N numbers; further
    arrays of N numbers become fields, and pose (4 x 4), time_s and labels are those of the scan.

    Raises FileNotFoundError and ValueError, with the file.
    """

    def __init__(
        self, path: str | os.PathLike[str], *, poses: str | os.PathLike[str] | None = None
    ) -> None:
        super().__init__(find_scans(Path(path), ENDINGS), poses)

    def _read(self, path: Path) -> Scan:
        try:
            return scan_of(path.stem, load(path))
        # What NumPy raises for files that are cut short or none of its own.
        except (ValueError, OSError, EOFError, MemoryError, zipfile.BadZipFile) as error:
            if isinstance(error, FileNotFoundError):
                raise
            raise ValueError(f"{path}: {error}") from error


def load(path: Path) -> Fields:
    if path.suffix.lower() == ".npy":
        # Mapped, which checks what the header promises before memory is taken for it.
        return {"points": np.array(np.load(path, mmap_mode="r", allow_pickle=False))}
    content = np.load(path, allow_pickle=False)
    if not isinstance(content, np.lib.npyio.NpzFile):
        raise ValueError("expected a file of NumPy's savez(), got another one")
    with content:
        return {name: content[name] for name in content.files}


def scan_of(name: str, content: Mapping[str, npt.NDArray[Any]]) -> Scan:
    rest = dict(content)
    pose, time_s, labels = (rest.pop(each, None) for each in ("pose", "time_s", "labels"))
    fields = fields_of(rest.pop("points")) if "points" in rest else {}
    count = len(next(iter(fields.values()))) if fields else len(np.atleast_1d(rest.get("x", [])))
    fields |= {each: array for each, array in rest.items() if array.shape[:1] == (count,)}
    if labels is not None and labels.shape != (count,):
        raise ValueError(f"labels: expected {count} of them, got shape {labels.shape}")
    if pose is not None and pose.shape != (4, 4):
        raise ValueError(f"pose: expected 4 x 4 numbers, got shape {pose.shape}")
    return Scan(
        name=name,
        points=points_of(fields, count),
        pose=None if pose is None else pose.astype(np.float64),
        time_s=None if time_s is None else float(time_s),
        labels=None if labels is None else labels.astype(np.uint32),
        fields=fields,
    )


def fields_of(points: npt.NDArray[Any]) -> Fields:
    """Columns or fields of an array. Raises ValueError where it holds no points."""
    if points.dtype.names is not None:
        flat = points.reshape(-1)
        return {name: np.ascontiguousarray(flat[name]) for name in points.dtype.names}
    if points.ndim != 2 or points.shape[1] < 3 or points.dtype.kind not in "fiu":
        raise ValueError("expected N x 3 or more numbers or records with x, y, z, got "
                         f"{points.dtype} of shape {points.shape}")
    return {name: np.ascontiguousarray(points[:, column])
            for column, name in enumerate(COLUMNS[: points.shape[1]])}
