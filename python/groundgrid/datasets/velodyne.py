"""Packet captures of Velodyne LiDARs."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from .extras import require
from .poses import pose_file
from .scan import Scan, points_of


def decoder_config(decoder: Any, model: str | None, calibration: Path | None) -> Any:
    """velodyne-decoder's. Raises ValueError and FileNotFoundError for what it does not know."""
    config = decoder.Config()
    if model is not None:
        models = decoder.Model.__members__
        if model not in models:
            raise ValueError(f"model: expected one of {', '.join(models)}, got {model!r}")
        config.model = models[model]
    if calibration is not None:
        if not calibration.is_file():
            raise FileNotFoundError(f"{calibration}: expected a calibration, got nothing of that "
                                    "name")
        try:
            config.calibration = decoder.Calibration.read(str(calibration))
        except (ValueError, KeyError, TypeError, RuntimeError) as error:
            raise ValueError(f"{calibration}: {error}") from error
    return config


class VelodyneDataset:
    """The turns of a .pcap file, one after the other.

    model: "VLP16", "HDL32E", "VLP32C", "HDL64E_S3", "AlphaPrime", ...: told by the packets where it
    is left out.
    calibration: a .yml file of the sensor's own angles, where the model's are not to be used.
    poses: poses of the sensor in KITTI's or TUM's form.

    Fields are intensity, ring, time (seconds from Scan.time_s on, that of the last packet, hence
    negative), and what else the decoder gives. Raises FileNotFoundError and ValueError, with the
    file, and ImportError where velodyne-decoder is missing.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        model: str | None = None,
        calibration: str | os.PathLike[str] | None = None,
        poses: str | os.PathLike[str] | None = None,
    ) -> None:
        self._path = Path(path)
        self._decoder = require("velodyne_decoder", "velodyne", "reading a Velodyne capture")
        self._poses = pose_file(poses)
        self._model = model
        self._calibration = None if calibration is None else Path(calibration)
        if not self._path.is_file():
            raise FileNotFoundError(f"{self._path}: expected a capture, got nothing of that name")
        self._config()

    def _config(self) -> Any:
        """A new one each time, since decoding writes into it."""
        return decoder_config(self._decoder, self._model, self._calibration)

    def __iter__(self) -> Iterator[Scan]:
        dpkt = require("dpkt", "velodyne", "reading a Velodyne capture")
        turns = 0
        try:
            for stamp, cloud in self._decoder.read_pcap(self._path, self._config(), True):
                yield self._scan(turns, stamp, cloud)
                turns += 1
        except (dpkt.Error, RuntimeError, ValueError, EOFError) as error:
            raise ValueError(f"{self._path}: expected a Velodyne capture, got: {error}") from error
        if turns == 0:
            raise ValueError(f"{self._path}: expected a Velodyne capture, got no whole turn")

    def _scan(self, index: int, stamp: Any, cloud: Any) -> Scan:
        time_s = float(stamp.host)
        fields = {name: np.ascontiguousarray(cloud[name]) for name in cloud.dtype.names}
        pose = None if self._poses is None else self._poses.pose(index, time_s)
        return Scan(f"{index:06}", points_of(fields, len(cloud)), pose, time_s, fields=fields)
