"""NumPy's own files: .npy and .npz."""

from __future__ import annotations

import os
import tokenize
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .map_coordinates import placed
from .scan import Scan, points_of
from .scan_files import ScanFiles, find_scans

ENDINGS = frozenset({".npy", ".npz"})
COLUMNS = ("x", "y", "z", "intensity")
# As the module has it: more columns than this, and than points, lie the other way round.
MOST_COLUMNS = 16
# Kinds of NumPy's types.
NUMBERS = "biuf"
# Those of the core.
RIGID_TOLERANCE, FARTHEST_M = 1e-3, 1e9
# What NumPy raises for files that are cut short, damaged or none of its own. RuntimeError is what
# zipfile raises for members that are encrypted or of a compression that it does not know.
ERRORS = (ValueError, OSError, EOFError, MemoryError, OverflowError, RuntimeError, TypeError,
          SyntaxError, LookupError, zipfile.BadZipFile, zlib.error, tokenize.TokenError)
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
            return scan_of(path.stem, load(path), self._poses is not None)
        except ERRORS as error:
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
        return {name: array_of(content, name) for name in content.files}


def array_of(content: Any, name: str) -> npt.NDArray[Any]:
    """One of a .npz file. Raises ValueError with its name where it cannot be read."""
    try:
        array = content[name]
    except ERRORS as error:
        raise ValueError(f"{name}: expected an array, got: {error}") from error
    # What NumPy gives of a member that is no array.
    if not isinstance(array, np.ndarray):
        raise ValueError(f"{name}: expected an array, got another file")
    return array


def scan_of(name: str, content: Mapping[str, npt.NDArray[Any]], has_pose: bool) -> Scan:
    """has_pose: whether one from elsewhere will take the place of the content's."""
    rest = dict(content)
    pose, time_s, labels = (rest.pop(each, None) for each in ("pose", "time_s", "labels"))
    fields = fields_of(rest.pop("points")) if "points" in rest else {}
    count = len(next(iter(fields.values()))) if fields else len(np.atleast_1d(rest.get("x", [])))
    fields |= {each: array for each, array in rest.items() if array.shape[:1] == (count,)}
    if pose is None and not has_pose:
        points, own = placed(fields, count)
    else:
        points, own = points_of(fields, count), None if pose is None else pose_of(pose)
    return Scan(
        name=name,
        points=points,
        pose=own,
        time_s=None if time_s is None else time_of(time_s),
        labels=None if labels is None else labels_of(labels, count),
        fields=fields,
    )


def check_numbers(name: str, array: npt.NDArray[Any]) -> None:
    if array.dtype.kind not in NUMBERS:
        raise ValueError(f"{name}: expected numbers, got {array.dtype}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers, got NaN or infinity")


def pose_of(pose: npt.NDArray[Any]) -> npt.NDArray[np.float64]:
    """With the checks of the core, which knows no file."""
    if pose.shape != (4, 4):
        raise ValueError(f"pose: expected 4 x 4 numbers, got shape {pose.shape}")
    check_numbers("pose", pose)
    matrix = pose.astype(np.float64)
    rotation = matrix[:3, :3]
    error = np.linalg.norm(rotation @ rotation.T - np.eye(3))
    if error > RIGID_TOLERANCE or np.linalg.det(rotation) < 0:
        raise ValueError("pose: expected a rotation and a translation, got a matrix that is not "
                         "rigid: its rotation is not orthonormal")
    if (matrix[3] != [0, 0, 0, 1]).any():
        raise ValueError(f"pose: expected 0 0 0 1 as the last row, got {matrix[3]}")
    if np.abs(matrix[:3, 3]).max() > FARTHEST_M:
        raise ValueError(f"pose: expected a place within {FARTHEST_M:g} m of the origin, got one "
                         "farther off")
    return matrix


def time_of(time_s: npt.NDArray[Any]) -> float:
    if time_s.size != 1:
        raise ValueError(f"time_s: expected a single number, got shape {time_s.shape}")
    check_numbers("time_s", time_s)
    return float(time_s.item())


def labels_of(labels: npt.NDArray[Any], count: int) -> npt.NDArray[np.uint32]:
    if labels.shape != (count,):
        raise ValueError(f"labels: expected {count} of them, got shape {labels.shape}")
    check_numbers("labels", labels)
    return labels.astype(np.uint32)


def fields_of(points: npt.NDArray[Any]) -> Fields:
    """Columns or fields of an array. Raises ValueError where it holds no points."""
    if points.dtype.names is not None:
        flat = points.reshape(-1)
        return {name: np.ascontiguousarray(flat[name]) for name in points.dtype.names}
    if points.ndim != 2 or points.shape[1] < 3 or points.dtype.kind not in "fiu":
        raise ValueError("expected N x 3 or more numbers or records with x, y, z, got "
                         f"{points.dtype} of shape {points.shape}")
    if len(points) and points.shape[1] > max(MOST_COLUMNS, len(points)):
        raise ValueError("expected a row for each point, x, y, z first, got shape "
                         f"{points.shape}; if it has a column for each point, store points.T")
    return {name: np.ascontiguousarray(points[:, column])
            for column, name in enumerate(COLUMNS[: points.shape[1]])}
