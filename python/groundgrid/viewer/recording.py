"""A drive as a Rerun recording."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import GroundGrid, Label, ScanResult, TerrainLayers, TraversabilityLimits
from ..datasets import Scan
from ..datasets.extras import require
from ..output_files import hidden_file
from .blueprint import blueprint
from .colors import LABELS, PATH
from .layer_images import images_of
from .terrain_mesh import mesh_of

# Of the screen, so that near points do not hide what is behind them.
POINT_RADIUS = 1.0
Matrix = npt.NDArray[np.float64]


@contextmanager
def pipe_to(hidden: Path, final: Path) -> Iterator[str]:
    """A path to write to in place of the hidden one. Rerun waits for ever once it cannot write, which
    into a pipe it always can. Raises OSError at the end, with the file to be, where the disk is full.
    """
    reading, writing = os.pipe()
    problems: list[OSError] = []

    def copy() -> None:
        with open(reading, "rb", buffering=0) as source, hidden.open("wb", buffering=0) as file:
            while block := source.read(1 << 16):
                try:
                    while block and not problems:
                        block = block[file.write(block):]
                except OSError as error:
                    problems.append(error)

    thread = threading.Thread(target=copy)
    thread.start()
    try:
        yield f"/proc/self/fd/{writing}"
    finally:
        os.close(writing)
        thread.join()
    if problems:
        raise OSError(f"{final}: cannot be written: {problems[0]}") from problems[0]


class Recording:
    """Writes scans coloured by label, the terrain as a mesh, its layers as images, the path and the
    time of each scan into a .rrd file, which is there complete at the end of the block or not at
    all.

    terrain_every: the terrain and its layers, some 2 MB, are written for one scan in so many, and
    for the first one.
    limits: of a vehicle, for the layers.

    Coordinates are relative to the first pose, in whole metres. Raises ImportError where rerun-sdk
    is missing.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        terrain_every: int = 5,
        limits: TraversabilityLimits | None = None,
    ) -> None:
        self._rerun = require("rerun", "view", "the viewer")
        self._path = Path(path)
        self._every = max(1, terrain_every)
        self._limits = limits or TraversabilityLimits()
        self._layers = TerrainLayers()
        self._origin = np.zeros(3)
        self._places: list[Matrix] = []
        self._stack = ExitStack()

    def __enter__(self) -> Recording:
        hidden = self._stack.enter_context(hidden_file(self._path))
        pipe = self._stack.enter_context(pipe_to(hidden, self._path))
        self._stream = self._rerun.RecordingStream("groundgrid")
        self._stack.callback(self._close)
        self._stream.save(pipe)
        self._stream.send_recording_name(self._path.stem)
        self._log("/world", self._rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if kind is None:
            with self._stack:
                self._add_path()
        else:
            self._stack.__exit__(kind, error, traceback)

    def _close(self) -> None:
        self._stream.flush()
        self._stream.disconnect()

    def _log(self, place: str, what: Any, static: bool = False) -> None:
        self._stream.log(place, what, static=static)

    def add(
        self, scan: Scan, result: ScanResult, grid: GroundGrid, milliseconds: float | None = None
    ) -> None:
        """One scan, right after the grid has processed it; milliseconds is what that took."""
        pose = np.eye(4) if scan.pose is None else scan.pose
        number = len(self._places)
        if number == 0:
            self._origin = np.round(pose[:3, 3])
            self._stream.send_blueprint(blueprint(grid.terrain.size))
        self._stream.set_time("scan", sequence=number)
        if scan.time_s is not None:
            self._stream.set_time("time", duration=scan.time_s)
        self._add_points(scan, result, pose)
        self._add_sensor(pose)
        self._add_figures(result, milliseconds)
        if number % self._every == 0:
            self._add_terrain(scan, result, grid)

    def _add_points(self, scan: Scan, result: ScanResult, pose: Matrix) -> None:
        finite = np.isfinite(scan.points[:, :3]).all(axis=1)
        turn, place = pose[:3, :3], pose[:3, 3] - self._origin
        points = (scan.points[:, :3] @ turn.T + place).astype(np.float32)
        for label, color in LABELS.items():
            chosen = points[finite & (result.labels == label)]
            self._log(f"/world/scan/{label.name.lower()}", self._rerun.Points3D(
                chosen, colors=[color], radii=[self._rerun.Radius.ui_points(POINT_RADIUS)],
                point_shading="Flat"))

    def _add_sensor(self, pose: Matrix) -> None:
        place = pose[:3, 3] - self._origin
        self._places.append(place)
        self._log("/world/sensor", self._rerun.Transform3D(translation=place, mat3x3=pose[:3, :3]))
        self._log("/world/sensor", self._rerun.TransformAxes3D(1.5))

    def _add_path(self) -> None:
        if self._places:
            path = self._rerun.LineStrips3D([np.array(self._places)], colors=[PATH], radii=[0.06])
            self._log("/world/path", path, static=True)

    def _add_figures(self, result: ScanResult, milliseconds: float | None) -> None:
        if milliseconds is not None:
            self._log("/time/process", self._rerun.Scalars(milliseconds))
        shares = 100 * np.bincount(result.labels, minlength=len(Label)) / max(1, len(result.labels))
        for label in LABELS:
            self._log(f"/share/{label.name.lower()}", self._rerun.Scalars(float(shares[label])))

    def _add_terrain(self, scan: Scan, result: ScanResult, grid: GroundGrid) -> None:
        terrain = grid.terrain
        self._layers.update(grid, scan.points, scan.pose, result.labels, limits=self._limits)
        mesh = mesh_of(terrain, self._origin)
        self._log("/world/terrain", self._rerun.Mesh3D(
            vertex_positions=mesh.vertices, triangle_indices=mesh.triangles,
            vertex_normals=mesh.normals, vertex_colors=mesh.colors))
        for name, image in images_of(terrain, self._layers):
            self._log(f"/layers/{name}", self._rerun.Image(image))
