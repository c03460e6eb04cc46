import os
from pathlib import Path

import numpy as np
import pytest

import groundgrid


@pytest.fixture(scope="session")
def drive():
    """Three scans of a small sensor in a town."""
    return groundgrid.simulation.Drive("urban", "vlp-16", scans=3, seed=4)


@pytest.fixture(scope="session")
def scan(drive):
    return drive[0]


@pytest.fixture(scope="session")
def real_data():
    """The folder of real scans; without it a skip, but where they must be there a failure."""
    default = Path(__file__).parents[2].parent / "shared" / "data"
    folder = Path(os.environ.get("GROUNDGRID_DATA", default))
    if not folder.is_dir():
        message = f"no real data at {folder}: set GROUNDGRID_DATA"
        if os.environ.get("GROUNDGRID_REQUIRE_DATA") == "1":
            pytest.fail(message)
        pytest.skip(message)
    return folder


@pytest.fixture
def plane():
    """Ground 1.5 m below the sensor, every 0.2 m up to 10 m, and a wall of 1 m at x = 6 m."""
    x, y = np.meshgrid(np.arange(-10, 10, 0.2), np.arange(-10, 10, 0.2))
    ground = np.stack([x.ravel(), y.ravel(), np.full(x.size, -1.5)], axis=1)
    across, up = np.meshgrid(np.arange(-2, 2, 0.1), np.arange(-1.1, -0.5, 0.1))
    wall = np.stack([np.full(across.size, 6.0), across.ravel(), up.ravel()], axis=1)
    return np.concatenate([ground, wall]).astype(np.float32)
