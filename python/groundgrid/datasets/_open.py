"""Chooses a loader by what is on disk."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from .bags import BagDataset
from .files import FileDataset

RECORDINGS = {".bag", ".mcap", ".db3"}


def open_dataset(path: str | os.PathLike[str], **options: Any) -> FileDataset | BagDataset:
    """Opens a dataset, a folder of scans, a scan or a recording; options are the loader's own.

    Raises FileNotFoundError and ValueError where there is nothing that a loader knows.
    """
    place = Path(path)
    if place.suffix.lower() in RECORDINGS or (place / "metadata.yaml").is_file():
        return BagDataset(place, **options)
    return FileDataset(place, **options)
