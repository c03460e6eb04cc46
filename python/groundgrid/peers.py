"""The open peers that PyPI carries, each with the settings published for it. docs/benchmarks.md has
them in a table, with their sources; benchmarks/peers/requirements.txt installs them.

A peer is made once a sequence, from the height of the sensor over the ground in metres. Its
`segment` takes N x 4 float32 (x, y, z, intensity, in the frame of the sensor) and gives an Answer.
This file stands for itself: benchmarks/peers uses it without the rest of the package.
"""

from __future__ import annotations

import dataclasses
import importlib
import tempfile
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float32]
Mask = npt.NDArray[np.bool_]


class PeerMissing(ImportError):
    """A peer's package cannot be loaded."""


@dataclasses.dataclass
class Answer:
    """What a peer says of a scan."""

    ground: Mask
    """N; what is not ground is non-ground."""

    own_ms: float | None = None
    """Of the method without the way from and to NumPy; None where it is not known."""


class Peer(Protocol):
    """A method that tells ground from the rest."""

    def segment(self, points: Points) -> Answer:
        """Of the points of one scan."""
        ...


def package(module: str, name: str) -> ModuleType:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise PeerMissing(f"{name} cannot be loaded ({error}); install "
                          "benchmarks/peers/requirements.txt, or leave it out with --methods"
                          ) from error


def mask_of(indices: Any, count: int) -> Mask:
    mask = np.zeros(count, bool)
    mask[np.asarray(indices, np.int64)] = True
    return mask


class Patchwork:
    """Both of pypatchworkpp's; they tell their own time in microseconds."""

    def __init__(self, method: Any) -> None:
        self._method = method

    def segment(self, points: Points) -> Answer:
        self._method.estimateGround(points)
        return Answer(mask_of(self._method.getGroundIndices(), len(points)),
                      self._method.getTimeTaken() / 1000)


def patchwork_plus_plus(sensor_height_m: float) -> Peer:
    module = package("pypatchworkpp", "Patchwork++")
    parameters = module.Parameters()
    parameters.sensor_height = sensor_height_m
    return Patchwork(module.patchworkpp(parameters))


def patchwork(sensor_height_m: float) -> Peer:
    module = package("pypatchworkpp", "Patchwork")
    parameters = module.PatchworkParams()
    parameters.sensor_height = sensor_height_m
    parameters.uprightness_thr = 0.707
    parameters.using_global_thr = False
    return Patchwork(module.patchwork(parameters))


LINEFIT_SETTINGS = """
[important]
height = {height}
[segments]
r_min = 0.1
r_max = 80
n_segments = 360
n_bins = 160
[ground]
min_slope = -0.1
max_slope = 0.1
long_threshold = 2.0
max_long_height = 0.2
max_start_height = 0.2
max_fit_error = 0.2
max_dist_to_line = 0.2
line_search_angle = 0.33
[general]
n_threads = 1
verbose = false
"""


class Linefit:
    def __init__(self, sensor_height_m: float) -> None:
        module = package("linefit", "linefit")
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as settings:
            settings.write(LINEFIT_SETTINGS.format(height=sensor_height_m))
            settings.flush()
            self._method = module.ground_seg(settings.name)

    def segment(self, points: Points) -> Answer:
        return Answer(self._method.run(points[:, :3]).astype(bool))


class Travel:
    """Needs no height of the sensor."""

    def __init__(self, _: float) -> None:
        self._method = package("travel_seg", "TRAVEL").TravelGroundSeg()

    def segment(self, points: Points) -> Answer:
        ground, seconds = self._method.estimate_ground(points)
        return Answer(ground, 1000 * seconds)


class Csf:
    """Needs no height of the sensor."""

    def __init__(self, class_threshold_m: float) -> None:
        self._module = package("CSF", "CSF")
        self._class_threshold_m = class_threshold_m

    def segment(self, points: Points) -> Answer:
        csf = self._module.CSF()
        csf.params.bSloopSmooth = True
        csf.params.cloth_resolution = 0.5
        csf.params.rigidness = 3
        csf.params.interations = 500
        csf.params.time_step = 0.65
        csf.params.class_threshold = self._class_threshold_m
        csf.setPointCloud(points[:, :3].astype(np.float64))
        ground, others = self._module.VecInt(), self._module.VecInt()
        begin = time.perf_counter()
        csf.do_filtering(ground, others, False)
        own_ms = 1000 * (time.perf_counter() - begin)
        return Answer(mask_of(ground, len(points)), own_ms)


class RansacPlane:
    """One plane a scan; needs no height of the sensor."""

    def __init__(self, _: float) -> None:
        self._open3d = package("open3d", "Open3D")
        self._open3d.utility.random.seed(0)

    def segment(self, points: Points) -> Answer:
        places = self._open3d.utility.Vector3dVector(points[:, :3].astype(np.float64))
        cloud = self._open3d.geometry.PointCloud(places)
        begin = time.perf_counter()
        _, ground = cloud.segment_plane(distance_threshold=0.15, ransac_n=3, num_iterations=500)
        own_ms = 1000 * (time.perf_counter() - begin)
        return Answer(mask_of(ground, len(points)), own_ms)


PEERS: dict[str, Callable[[float], Peer]] = {
    "patchwork++": patchwork_plus_plus,
    "patchwork": patchwork,
    "linefit": Linefit,
    "travel": Travel,
    "csf": lambda _: Csf(0.5),
    "csf 0.1 m": lambda _: Csf(0.1),
    "ransac plane": RansacPlane,
}
