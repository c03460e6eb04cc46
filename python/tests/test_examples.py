"""examples/python, as they are."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import rasterio

import groundgrid

EXAMPLES = Path(__file__).parents[2] / "examples" / "python"


def run(name, *arguments):
    env = os.environ | {"PYTHONPATH": str(Path(groundgrid.__file__).parents[1])}
    done = subprocess.run([sys.executable, str(EXAMPLES / name), *map(str, arguments)], env=env,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", text)]


def test_one_scan():
    first, second, third = run("one_scan.py").splitlines()
    points, ground, obstacles, outliers, unknown = numbers(first)
    assert points == ground + obstacles + outliers + unknown and ground > 30000
    assert 1.4 < numbers(second)[0] < 2.0 and 2 < numbers(third)[0] < 60


def test_one_real_scan(real_data):
    scan = real_data / "semantickitti/sequences/00/velodyne/000000.bin"
    first, second, _ = run("one_scan.py", scan).splitlines()
    assert numbers(first)[0] == scan.stat().st_size / 16
    assert numbers(second)[0] == pytest.approx(1.73, abs=0.1)


def test_a_drive_with_a_terrain_map(tmp_path):
    _, under, yes, no, steepest = run("drive_terrain.py", tmp_path / "terrain.tif").splitlines()
    height, deviation = numbers(under)
    assert -2.0 < height < -1.4 and 0 < deviation < 0.5
    assert numbers(yes)[0] > 300 and 0 < numbers(no)[0] < numbers(yes)[0]
    assert 0 < numbers(steepest)[0] < 90
    with rasterio.open(tmp_path / "terrain.tif") as raster:
        assert raster.descriptions[0] == "height"


def test_a_bag():
    lines = run("bag.py").splitlines()
    assert len(lines) == 5 and all(line.startswith("/points at 0.") for line in lines)
    assert all(line.endswith("m ahead") or line.endswith("nothing ahead") for line in lines)
