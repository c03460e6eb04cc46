"""Messages of a recording that are clouds, or packets that become one: their fields by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import pointcloud2
from .extras import require
from .velodyne import decoder_config

Fields = dict[str, npt.NDArray[Any]]
CLOUD = "sensor_msgs/msg/PointCloud2"
CLOUD_FIELD = "sensor_msgs/msg/PointField"
VELODYNE = "velodyne_msgs/msg/VelodyneScan"
# Of the drivers for ROS 1, ROS 2 and both.
LIVOX_PACKAGES = "livox_ros_driver", "livox_interfaces", "livox_ros_driver2"
LIVOX = tuple(f"{package}/msg/CustomMsg" for package in LIVOX_PACKAGES)
READABLE = CLOUD, *LIVOX, VELODYNE
# Members of a point of Livox and the fields that they become, those of its PointCloud2.
LIVOX_FIELDS = {"x": ("x", "f4"), "y": ("y", "f4"), "z": ("z", "f4"),
                "reflectivity": ("intensity", "u1"), "offset_time": ("t", "u4"),
                "tag": ("tag", "u1"), "line": ("line", "u1")}


def definitions() -> dict[str, str]:
    """Of the messages that are not ROS's own, for recordings that have none."""
    texts = {"velodyne_msgs/msg/VelodynePacket":
             "builtin_interfaces/Time stamp\nuint8[1206] data\n",
             VELODYNE: "std_msgs/Header header\nvelodyne_msgs/VelodynePacket[] packets\n"}
    for package in LIVOX_PACKAGES:
        texts[f"{package}/msg/CustomPoint"] = (
            "uint32 offset_time\nfloat32 x\nfloat32 y\nfloat32 z\nuint8 reflectivity\nuint8 tag\n"
            "uint8 line\n")
        texts[f"{package}/msg/CustomMsg"] = (
            "std_msgs/Header header\nuint64 timebase\nuint32 point_num\nuint8 lidar_id\n"
            f"uint8[3] rsvd\n{package}/CustomPoint[] points\n")
    return texts


def decoders(model: str | None, calibration: Path | None) -> Mapping[str, Callable[[Any], Fields]]:
    """What makes fields of a message, by its type."""
    return {CLOUD: pointcloud2.fields_of, VELODYNE: VelodyneScans(model, calibration),
            **dict.fromkeys(LIVOX, livox_fields)}


def livox_fields(message: Any) -> Fields:
    """Those of Livox's PointCloud2, and t, nanoseconds from the scan's first point on."""
    points = message.points
    if message.point_num != len(points):
        raise ValueError(f"expected as many points as it counts, {message.point_num}, got "
                         f"{len(points)}")
    return {field: np.fromiter((getattr(each, name) for each in points), kind, len(points))
            for name, (field, kind) in LIVOX_FIELDS.items()}


class VelodyneScans:
    """Makes fields of scans of packets; the model is that of the first one if none is given."""

    def __init__(self, model: str | None, calibration: Path | None) -> None:
        self._model, self._calibration = model, calibration
        self._decoder: Any = None

    def __call__(self, message: Any) -> Fields:
        """Fields of velodyne-decoder; time is in seconds from the header's on."""
        library = require("velodyne_decoder", "velodyne", "reading Velodyne packets")
        if self._decoder is None:
            config = decoder_config(library, self._model, self._calibration)
            self._decoder = library.ScanDecoder(config)
        packets = library.PacketVector([library.VelodynePacket(seconds(each.stamp), each.data)
                                        for each in message.packets])
        try:
            stamp, cloud = self._decoder.decode(packets, True)
        except RuntimeError as error:
            raise ValueError(f"expected Velodyne packets, got: {error}") from error
        fields = {name: np.ascontiguousarray(cloud[name]) for name in cloud.dtype.names}
        fields["time"] += np.float32(stamp.host - seconds(message.header.stamp))
        return fields


def seconds(stamp: Any) -> float:
    return int(stamp.sec) + int(stamp.nanosec) * 1e-9
