"""groundgrid-py: anything that a loader reads, from the shell."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import Any

from .. import __version__
from . import compare, rasterize, run, view

COMMANDS = (run, view, compare, rasterize)


class Parser(argparse.ArgumentParser):
    """Takes no option for a longer one that begins with it; its commands' do not, either."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(allow_abbrev=False, **settings)


def parser() -> argparse.ArgumentParser:
    root = Parser(
        prog="groundgrid-py", description="Ground segmentation of recordings and point clouds."
    )
    root.add_argument("--version", action="version", version=__version__)
    commands = root.add_subparsers(required=True, metavar="COMMAND")
    for each in COMMANDS:
        each.add_to(commands)
    return root


def main(arguments: Sequence[str] | None = None) -> int:
    """0 done, 1 bad input, 2 usage, as the program groundgrid has them."""
    options = parser().parse_args(arguments)
    try:
        options.command(options)
    except (ValueError, OSError, ImportError) as error:
        print(f"groundgrid-py: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("groundgrid-py: interrupted", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
