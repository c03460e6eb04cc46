"""What an optional loader needs."""

from __future__ import annotations

import importlib
from types import ModuleType


def require(module: str, extra: str, what: str) -> ModuleType:
    """Imports a module of an extra. Raises ImportError with the line that installs it."""
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        raise ImportError(
            f"{what} needs {module.partition('.')[0]}: pip install 'groundgrid[{extra}]'"
        ) from error
