"""What is installed, and what it brings along."""

import importlib.metadata
import re
import subprocess
import sys
from pathlib import Path

import pytest

import groundgrid


PROGRAM = """
import groundgrid
grid = groundgrid.GroundGrid()
for scan in groundgrid.simulation.Drive("urban", "vlp-16", scans=1):
    grid.process(scan.points, scan.pose)
print(open("/proc/self/maps").read())
"""


@pytest.fixture(scope="module")
def libraries():
    """Those in memory once all of the package has run, in a process where nothing else has."""
    if not Path("/proc/self/maps").exists():
        pytest.skip("only Linux tells which libraries are in memory")
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    found = set(re.findall(r"/\S+\.so[.\d]*", done.stdout))
    assert any("_core" in path for path in found)
    return found


def test_brings_no_gdal(libraries):
    assert not [path for path in libraries if "gdal" in path]


def test_a_repaired_wheel_uses_its_own_libraries(libraries):
    bundled = Path(groundgrid.__file__).parent.parent / "groundgrid.libs"
    if not bundled.is_dir():
        pytest.skip("no repaired wheel: the libraries are the system's")
    used = [Path(path) for path in libraries if re.search("embree|tbb|fmt|hwy|lzf", path)]
    assert len(used) == 5
    assert all(path.parent == bundled for path in used)


def test_the_version_is_that_of_the_package():
    assert re.fullmatch(r"\d+\.\d+\.\d+", groundgrid.__version__)
    try:
        installed = importlib.metadata.version("groundgrid")
    except importlib.metadata.PackageNotFoundError:
        project = (Path(__file__).parents[2] / "pyproject.toml").read_text()
        installed = re.search(r'^version = "(.*)"', project, re.MULTILINE)[1]
    assert groundgrid.__version__ == installed
