"""ROS 1 and ROS 2 bags and MCAP files: PointCloud2 messages, and poses from odometry or TF."""

from __future__ import annotations

import os
import sqlite3
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .extras import require
from .pointcloud2 import fields_of
from .scan import Scan, points_of
from .transforms import FrameTree

CLOUD = "sensor_msgs/msg/PointCloud2"
ODOMETRY = "nav_msgs/msg/Odometry"
TRANSFORMS = "tf2_msgs/msg/TFMessage"


def nanoseconds(stamp: Any) -> int:
    return int(stamp.sec) * 1_000_000_000 + int(stamp.nanosec)


class BagDataset:
    """The clouds of one topic of a recording, in the order in which they were recorded.

    path: a ROS 1 .bag, an .mcap or .db3 file, or the folder of a ROS 2 bag.
    topic: that of the clouds; the only one of PointCloud2 where it is left out.
    frame: the frame that poses are in; the root of the tree of frames where it is left out.
    odometry: the topic of odometry to take poses from, in place of TF where both have them.

    Poses are those of the cloud's own frame, interpolated at the time of its header; None where
    neither TF nor odometry has them. Raises FileNotFoundError, ValueError for what is no recording
    or has no such topic, and ImportError where rosbags is not installed.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        topic: str | None = None,
        frame: str | None = None,
        odometry: str | None = None,
    ) -> None:
        self._path = Path(path)
        self._frame = frame
        with self.reader() as reader:
            clouds = {each.topic for each in reader.connections if each.msgtype == CLOUD}
            self.topic: str = self._choose(sorted(clouds), topic)
            wanted = [each for each in reader.connections if each.topic == self.topic]
            self._count = sum(int(each.msgcount) for each in wanted)
            self._frames = self._read_frames(reader, odometry)

    @contextmanager
    def reader(self) -> Iterator[Any]:
        """rosbags' AnyReader of the whole recording; its errors are ValueError."""
        anyreader = require("rosbags.highlevel", "bags", "reading a recording")
        typesys = require("rosbags.typesys", "bags", "reading a recording")
        if not self._path.exists():
            raise FileNotFoundError(f"{self._path}: expected a recording, got nothing of that name")
        store = typesys.get_typestore(typesys.Stores.LATEST)
        try:
            with anyreader.AnyReader([self._path], default_typestore=store) as reader:
                yield reader
        # What it raises for files that are cut short or none at all.
        except (anyreader.AnyReaderError, sqlite3.Error, struct.error, LookupError) as error:
            raise ValueError(f"{self._path}: expected a recording, got: {error}") from error

    def _choose(self, topics: list[str], wanted: str | None) -> str:
        names = ", ".join(topics) or "none"
        if wanted is None and len(topics) == 1:
            return topics[0]
        if wanted not in topics:
            expected = "one topic of PointCloud2" if wanted is None else f"clouds on {wanted}"
            raise ValueError(f"{self._path}: expected {expected}, got {names}")
        return wanted

    def _read_frames(self, reader: Any, odometry: str | None) -> FrameTree:
        frames = FrameTree()
        wanted = [each for each in reader.connections if each.msgtype == TRANSFORMS]
        for connection, _, raw in reader.messages(connections=wanted) if wanted else ():
            is_fixed = connection.topic.endswith("tf_static")
            for each in reader.deserialize(raw, connection.msgtype).transforms:
                parent, child = each.header.frame_id.lstrip("/"), each.child_frame_id.lstrip("/")
                place = each.transform.translation, each.transform.rotation
                if is_fixed:
                    frames.add_fixed(parent, child, *place)
                elif odometry is None or child != self._child_of(reader, odometry):
                    frames.add_moving(parent, child, nanoseconds(each.header.stamp), *place)
        self._add_odometry(reader, frames, odometry)
        return frames

    def _odometry(self, reader: Any, topic: str | None) -> Iterator[Any]:
        wanted = [each for each in reader.connections
                  if each.msgtype == ODOMETRY and topic in (None, each.topic)]
        if topic is not None and not wanted:
            raise ValueError(f"{self._path}: expected odometry on {topic}, got none")
        for connection, _, raw in reader.messages(connections=wanted) if wanted else ():
            yield reader.deserialize(raw, connection.msgtype)

    def _child_of(self, reader: Any, topic: str) -> str | None:
        first = next(self._odometry(reader, topic), None)
        return None if first is None else str(first.child_frame_id).lstrip("/")

    def _add_odometry(self, reader: Any, frames: FrameTree, topic: str | None) -> None:
        from_tf: dict[str, bool] = {}
        for message in self._odometry(reader, topic):
            child = message.child_frame_id.lstrip("/")
            if from_tf.setdefault(child, frames.knows(child)):
                continue
            pose = message.pose.pose
            frames.add_moving(message.header.frame_id.lstrip("/"), child,
                              nanoseconds(message.header.stamp), pose.position, pose.orientation)

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Scan]:
        with self.reader() as reader:
            wanted = [each for each in reader.connections if each.topic == self.topic]
            for index, (connection, _, raw) in enumerate(reader.messages(connections=wanted)):
                yield self._scan(index, reader.deserialize(raw, connection.msgtype))

    def _scan(self, index: int, message: Any) -> Scan:
        try:
            fields = fields_of(message)
            count = message.height * message.width
            points = points_of(fields, count)
        except ValueError as error:
            raise ValueError(f"{self._path}: message {index} of {self.topic}: {error}") from error
        time_ns = nanoseconds(message.header.stamp)
        frame = message.header.frame_id.lstrip("/")
        return Scan(
            name=f"{index:06}",
            points=points,
            pose=self._frames.pose(frame, time_ns, self._frame),
            time_s=time_ns * 1e-9,
            fields=fields,
        )
