"""Chooses a loader by what is on disk."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol

from . import arrays, captures, las
from .arrays import ArrayDataset
from .bags import BagDataset
from .files import FileDataset
from .las import LasDataset
from .ouster import OusterDataset
from .scan import Scan
from .velodyne import VelodyneDataset

RECORDINGS = frozenset({".bag", ".mcap", ".db3"})
# Folders with these are FileDataset's, whatever lies beside them.
FILES = frozenset({".bin", ".pcd", ".ply"})


class Dataset(Protocol):
    """Scans in the order in which they were taken. Most know their number, too: len()."""

    def __iter__(self) -> Iterator[Scan]: ...


def open_dataset(path: str | os.PathLike[str], **options: Any) -> Dataset:
    """Opens a dataset, a folder of scans, a scan or a recording; options are the loader's own.

    Raises FileNotFoundError and ValueError where there is nothing that a loader knows, TypeError
    for options that the loader does not have, and ImportError, with the line that installs it,
    where a package is missing.
    """
    place = Path(path)
    return loader_of(place)(place, **options)


def loader_of(place: Path) -> Callable[..., Dataset]:
    ending = place.suffix.lower()
    if ending in RECORDINGS or (place / "metadata.yaml").is_file():
        return BagDataset
    if ending in captures.ENDINGS and place.is_file():
        return VelodyneDataset if captures.is_velodyne(place) else OusterDataset
    if ending == ".osf":
        return OusterDataset
    endings = {ending}
    if place.is_dir():
        endings = {each.suffix.lower() for each in place.iterdir()}
        if endings & FILES:
            return FileDataset
    if endings & arrays.ENDINGS:
        return ArrayDataset
    return LasDataset if endings & las.ENDINGS else FileDataset
