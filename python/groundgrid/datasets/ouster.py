"""Packet captures of Ouster LiDARs, and their OSF files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from .extras import require
from .poses import pose_file
from .scan import Scan, points_of


class OusterDataset:
    """The frames of a .pcap or .osf file, one after the other, of one sensor.

    metadata: the sensor's .json file; that beside the capture with a name like its where it is left
    out.
    sensor: which one, from 0 on, where there are several.
    poses: poses of the sensor in KITTI's or TUM's form.

    Points come ring after ring from the top, in the order in which each was measured; those without
    a return are (0, 0, 0). Fields are ring, t (nanoseconds from Scan.time_s on), range
    (millimetres) and what else the sensor measured, with intensity its signal, or its reflectivity
    where it sends no signal. Raises FileNotFoundError and ValueError, with the file, and
    ImportError where ouster-sdk is missing.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        metadata: str | os.PathLike[str] | None = None,
        sensor: int = 0,
        poses: str | os.PathLike[str] | None = None,
    ) -> None:
        self._path = Path(path)
        self._core = require("ouster.sdk.core", "ouster", "reading an Ouster capture")
        self._poses = pose_file(poses)
        self._sensor = sensor
        self._options: dict[str, Any] = {}
        for each in (self._path, *([] if metadata is None else [Path(metadata)])):
            if not each.is_file():
                raise FileNotFoundError(f"{each}: expected a file, got nothing of that name")
        if metadata is not None:
            self._options["meta"] = [os.fspath(metadata)]
        self._tables: dict[int, Any] = {}
        with self._open() as source:
            self._count = len(source)
            sensors = len(source.sensor_info)
        if self._count == 0:
            raise ValueError(f"{self._path}: expected an Ouster capture, got no frame that is the "
                             "metadata's")
        if not 0 <= sensor < sensors:
            raise ValueError(f"{self._path}: expected a sensor from 0 to {sensors - 1}, "
                             f"got {sensor}")

    @contextmanager
    def _open(self) -> Iterator[Any]:
        sdk = require("ouster.sdk", "ouster", "reading an Ouster capture")
        try:
            source = sdk.open_source(os.fspath(self._path), index=True, **self._options)
        # What the SDK raises for files that it cannot make sense of.
        except (sdk.SourceURLException, RuntimeError, ValueError, TypeError) as error:
            raise ValueError(f"{self._path}: expected an Ouster capture, got: {error}") from error
        try:
            yield source
        finally:
            source.close()

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Scan]:
        with self._open() as source:
            for index, frames in enumerate(source):
                frame = frames[self._sensor]
                if frame is not None:
                    yield self._scan(index, frame)

    def _scan(self, index: int, frame: Any) -> Scan:
        table = self._tables.get(self._sensor)
        if table is None:
            table = self._core.XYZLut(frame.sensor_info, use_extrinsics=False)
            self._tables[self._sensor] = table
        places = np.asarray(table(frame)).reshape(-1, 3)
        times_ns = np.asarray(frame.timestamp, np.int64)
        first_ns = int(times_ns[times_ns > 0].min(initial=np.iinfo(np.int64).max))
        fields: dict[str, Any] = dict(zip("xyz", places.T))
        fields |= {str(name).lower(): np.asarray(frame.field(name)).reshape(-1)
                   for name in frame.fields if np.shape(frame.field(name)) == (frame.h, frame.w)}
        fields["intensity"] = fields.get("signal", fields.get("reflectivity", np.zeros(len(places))))
        fields["ring"] = np.repeat(np.arange(frame.h, dtype=np.uint16), frame.w)
        fields["t"] = np.tile(np.maximum(times_ns - first_ns, 0).astype(np.uint32), frame.h)
        pose = None if self._poses is None else self._poses.pose(index, first_ns * 1e-9)
        return Scan(f"{index:06}", points_of(fields, len(places)), pose, first_ns * 1e-9,
                    fields=fields)
