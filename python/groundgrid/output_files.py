"""Files that appear complete or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def hidden_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """A hidden path beside the file to be, which takes its name where the block ends without an
    error, and is removed where it ends with one. Raises FileNotFoundError without its folder."""
    final = Path(path)
    if not final.parent.is_dir():
        raise FileNotFoundError(f"{final}: expected the folder {final.parent}, got nothing of that "
                                "name")
    handle, name = tempfile.mkstemp(prefix=f".{final.name}.", suffix=final.suffix, dir=final.parent)
    os.close(handle)
    hidden = Path(name)
    try:
        yield hidden
        # mkstemp() makes files that only their owner reads.
        umask = os.umask(0)
        os.umask(umask)
        hidden.chmod(0o666 & ~umask)
        hidden.replace(final)
    finally:
        hidden.unlink(missing_ok=True)
