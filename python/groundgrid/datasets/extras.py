"""What an optional loader needs."""

from __future__ import annotations

import importlib
from types import ModuleType


# Its package takes only old versions of what the others need, and pip would put them in their place.
ALONE = "ouster"


def require(module: str, extra: str, what: str) -> ModuleType:
    """Imports a module of an extra. Raises ImportError with the line that installs it."""
    name = module.partition(".")[0]
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        place = ", in a virtual environment of its own" if extra == ALONE else ""
        raise ImportError(
            f"{what} needs {name}: pip install 'groundgrid[{extra}]'{place}"
        ) from error
    except ImportError as error:
        raise ImportError(f"{what} needs {name}, which cannot be loaded: {error}") from error
