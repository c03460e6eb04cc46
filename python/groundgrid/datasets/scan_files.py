"""Sources with one scan a file."""

from __future__ import annotations

import os
from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator
from pathlib import Path

from .poses import pose_file
from .scan import Scan


def find_scans(path: Path, endings: Collection[str]) -> list[Path]:
    """The file itself, or those of a folder in the order of their numbers, else of their names.

    Raises FileNotFoundError and ValueError where there is none.
    """
    names = " or ".join(sorted(endings))
    if not path.exists():
        raise FileNotFoundError(f"{path}: expected {names}, got nothing of that name")
    if not path.is_dir():
        return [path]
    found = [each for each in path.iterdir()
             if each.suffix.lower() in endings and not each.name.startswith(".")]
    if not found:
        raise ValueError(f"{path}: expected files {names}, got none")
    first: dict[str, Path] = {}
    for each in found:
        if first.setdefault(each.stem, each) != each:
            raise ValueError(f"{path}: expected one file a scan, got {first[each.stem].name} and "
                             f"{each.name}: their results would have one name")
    if all(each.stem.isdecimal() for each in found):
        return sorted(found, key=lambda each: (int(each.stem), each.name))
    return sorted(found)


class ScanFiles(ABC):
    """Scans that are read one by one when they are asked for."""

    def __init__(self, files: list[Path], poses: str | os.PathLike[str] | None) -> None:
        self.files = files
        """One a scan, in their order."""
        self._poses = pose_file(poses)

    @abstractmethod
    def _read(self, path: Path) -> Scan:
        """The scan with what the file itself says."""

    def __len__(self) -> int:
        return len(self.files)

    def __getitem__(self, index: int) -> Scan:
        place = range(len(self.files))[index]
        scan = self._read(self.files[place])
        if self._poses is None:
            return scan
        return scan.at(self._poses.pose(place, scan.time_s))

    def __iter__(self) -> Iterator[Scan]:
        return (self[index] for index in range(len(self)))
