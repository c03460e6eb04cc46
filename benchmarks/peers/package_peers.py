"""What the Python package has for peers, without the package, whose C++ need not be built."""

import importlib.util
import pathlib
import sys

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "python/groundgrid"


def module_of(file):
    """By itself; it must not need the rest of the package."""
    spec = importlib.util.spec_from_file_location(f"groundgrid_{file.stem}", file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


peers = module_of(PACKAGE / "peers.py")
PEERS, PeerMissing = peers.PEERS, peers.PeerMissing
silenced = module_of(PACKAGE / "program/native_output.py").silenced
