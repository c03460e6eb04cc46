"""What is installed, and what it brings along."""

import importlib.metadata
import re
from pathlib import Path

import pytest

import groundgrid


def libraries_in_memory():
    maps = Path("/proc/self/maps")
    if not maps.exists():
        pytest.skip("only Linux tells which libraries are in memory")
    return set(re.findall(r"/\S+\.so[.\d]*", maps.read_text()))


def test_brings_no_gdal():
    groundgrid.simulation.Drive("urban", "vlp-16", scans=1)
    assert not [path for path in libraries_in_memory() if "gdal" in path]


def test_a_repaired_wheel_uses_its_own_libraries():
    bundled = Path(groundgrid.__file__).parent.parent / "groundgrid.libs"
    if not bundled.is_dir():
        pytest.skip("no repaired wheel: the libraries are the system's")
    groundgrid.simulation.Drive("urban", "vlp-16", scans=1)
    used = [path for path in libraries_in_memory() if re.search("embree|tbb|fmt", path)]
    assert len(used) == 3
    assert all(Path(path).parent == bundled for path in used)


def test_the_version_is_that_of_the_package():
    assert re.fullmatch(r"\d+\.\d+\.\d+", groundgrid.__version__)
    try:
        installed = importlib.metadata.version("groundgrid")
    except importlib.metadata.PackageNotFoundError:
        project = (Path(__file__).parents[2] / "pyproject.toml").read_text()
        installed = re.search(r'^version = "(.*)"', project, re.MULTILINE)[1]
    assert groundgrid.__version__ == installed
