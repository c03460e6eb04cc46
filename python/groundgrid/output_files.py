"""Files that appear complete or not at all, and folders that one run at a time writes to.

What they are made of is the program groundgrid's, so that runs of both respect each other.
"""

from __future__ import annotations

import fcntl
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ._core import FolderLock, HiddenFile, hidden_name, make_folder, remove_leftovers, sync_folder


@contextmanager
def hidden_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A hidden path beside the file to be, which takes its name where the block ends without an
    error, and is removed where it ends with one. Raises FileNotFoundError without its folder."""
    file = HiddenFile(path)
    try:
        yield Path(file.hidden)
        file.commit()
    finally:
        file.discard()


@contextmanager
def hidden_folder(path: str | os.PathLike[str]) -> Iterator[Path]:
    """The same for what is a folder: a path of the same name, where nothing is yet, in a hidden
    folder beside it."""
    final = Path(path)
    folder = final.parent / hidden_name()
    folder.mkdir(0o700)
    handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        # By this others tell it from those of killed runs.
        fcntl.flock(handle, fcntl.LOCK_EX)
        hidden = folder / final.name
        yield hidden
        for each in (hidden, *hidden.rglob("*")):
            sync(each)
        hidden.rename(final)
        sync_folder(final.parent)
    finally:
        os.close(handle)
        shutil.rmtree(folder, ignore_errors=True)


def sync(path: Path) -> None:
    """Has a file or folder written to the disk."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


@contextmanager
def locked_folder(folder: Path) -> Iterator[None]:
    """A folder that no other run writes to, of this program or of groundgrid; made where it is not
    there. Raises ValueError where one does."""
    make_folder(folder)
    lock = FolderLock(folder)
    try:
        remove_leftovers(folder)
        yield
    finally:
        lock.release()


def clean_folder(folder: Path) -> None:
    """Makes a folder below one that is locked, and takes away what killed runs left in it."""
    make_folder(folder)
    remove_leftovers(folder)


def remove_file(path: Path) -> None:
    """So that it is not back after a power failure, beside files that are newer."""
    if path.exists():
        path.unlink()
        sync_folder(path.parent)
