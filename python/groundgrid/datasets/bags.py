"""ROS 1 and ROS 2 bags and MCAP files: messages that are clouds, and poses from odometry or TF."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from .cloud_messages import CLOUD, READABLE, decoders, definitions
from .extras import require
from .map_coordinates import are_of_a_map, told_from, told_from_middle
from .poses import pose_file
from .scan import Scan, points_of
from .transforms import FrameTree, Matrix, PoseMissing

ODOMETRY = "nav_msgs/msg/Odometry"
TRANSFORMS = "tf2_msgs/msg/TFMessage"


def nanoseconds(stamp: Any) -> int:
    return int(stamp.sec) * 1_000_000_000 + int(stamp.nanosec)


# What a message raises that the recording defines otherwise than ROS does.
OTHERWISE = AttributeError, TypeError


@contextmanager
def naming(path: Path, *kinds: type[Exception]) -> Iterator[None]:
    """Errors of these kinds are ValueError with the file's name; without kinds, all are.

    The library raises of everything, apsw's and assertions among it, over a damaged file.
    """
    try:
        yield
    except kinds or Exception as error:
        if isinstance(error, OSError) and error.filename is not None:
            raise
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise ValueError(f"{path}: expected a recording, got: {lines[0]}") from error


class Recording:
    """A recording that is open, of rosbags' AnyReader. Raises ValueError where it is damaged."""

    def __init__(self, path: Path, reader: Any) -> None:
        self.path = path
        self.connections: list[Any] = reader.connections
        self.typestore: Any = reader.typestore
        self.is2: bool = reader.is2
        self._reader = reader

    def messages(self, connections: list[Any] | None = None) -> Iterator[tuple[Any, int, Any]]:
        """Connection, time of recording in ns, and bytes; of all connections if none are given."""
        if connections == []:
            return
        messages = self._reader.messages(connections=connections or ())
        while True:
            with naming(self.path):
                message = next(messages, None)
            if message is None:
                return
            yield message

    def deserialize(self, raw: Any, connection: Any) -> Any:
        with naming(self.path):
            return self._reader.deserialize(raw, connection.msgtype)


def add(frames: FrameTree, topic: str, header: Any, child: str, pose: tuple[Any, Any],
        is_fixed: bool = False) -> None:
    """A position and an orientation of a topic; bad ones matter only to poses that need them."""
    child, parent = child.lstrip("/"), header.frame_id.lstrip("/")
    try:
        if is_fixed:
            frames.add_fixed(parent, child, *pose)
        else:
            frames.add_moving(parent, child, nanoseconds(header.stamp), *pose)
    except ValueError as error:
        frames.refuse(child, f"{error} on {topic}; choose a topic of odometry with odometry=")


class BagDataset:
    """The clouds of one topic of a recording, in the order in which they were recorded.

    path: a ROS 1 .bag, an .mcap or .db3 file, or the folder of a ROS 2 bag.
    topic: that of the clouds, PointCloud2, Livox's CustomMsg or Velodyne's packets (VelodyneScan);
    the only one of PointCloud2, else the only one, where it is left out.
    frame: the frame that poses are in; the root of the tree of frames where it is left out.
    odometry: the topic of odometry to take poses from, in place of TF where both have them. Clouds
    that are in the frame in which it places the sensor, as registered ones are, are told from the
    sensor.
    poses: poses of the sensor in KITTI's or TUM's form, in place of those of the recording.
    model, calibration: of Velodyne packets, as VelodyneDataset has them.

    Poses are those of the cloud's own frame, interpolated at the time of its header; None where
    neither TF nor odometry has them: Scan.pose_missing then says what is missing. Raises
    FileNotFoundError, ValueError for what is no recording or has no such topic or frame, and for
    poses that are not numbers or come from several parents or topics of odometry at once, and
    ImportError where rosbags is not installed.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        *,
        topic: str | None = None,
        frame: str | None = None,
        odometry: str | None = None,
        poses: str | os.PathLike[str] | None = None,
        model: str | None = None,
        calibration: str | os.PathLike[str] | None = None,
    ) -> None:
        if poses is not None and (frame is not None or odometry is not None):
            raise ValueError("poses: expected without frame and odometry, which choose those of "
                             "the recording")
        self._path = Path(path)
        self._poses = pose_file(poses)
        self._sensor: str | None = None
        """The frame to tell clouds from, where that is not their own."""
        self._decoders = decoders(model, None if calibration is None else Path(calibration))
        self._frame = None if frame is None else frame.lstrip("/")
        with self.reader() as recording, naming(self._path, *OTHERWISE):
            types = {each.topic: each.msgtype for each in recording.connections}
            self.topic: str = self._choose(types, topic)
            self._count = sum(int(each.msgcount) for each in self._connections(recording))
            self._frames = FrameTree()
            if self._poses is None:
                own = self._read_frames(recording, odometry)
                self._check_frames(recording, odometry, own)

    @property
    def files(self) -> list[Path]:
        """Those of the recording."""
        if not self._path.is_dir():
            return [self._path]
        return [each for each in self._path.iterdir() if each.suffix in (".db3", ".mcap", ".yaml")]

    @contextmanager
    def reader(self) -> Iterator[Recording]:
        """The whole recording; what rosbags raises over it is ValueError."""
        anyreader = require("rosbags.highlevel", "bags", "reading a recording")
        typesys = require("rosbags.typesys", "bags", "reading a recording")
        if not self._path.exists():
            raise FileNotFoundError(f"{self._path}: expected a recording, got nothing of that name")
        ending = self._path.suffix
        if ending != ending.lower() and self._path.is_file():
            raise ValueError(f"{self._path}: expected the ending {ending.lower()}, by which "
                             f"rosbags knows recordings, got {ending}: rename the file")
        store = typesys.get_typestore(typesys.Stores.LATEST)
        for name, text in definitions().items():
            store.register(typesys.get_types_from_msg(text, name))
        with naming(self._path):
            reader = anyreader.AnyReader([self._path], default_typestore=store)
            reader.open()
        try:
            yield Recording(self._path, reader)
        finally:
            reader.close()

    def _choose(self, types: dict[str, str], wanted: str | None) -> str:
        readable = sorted(topic for topic in types if types[topic] in READABLE)
        if wanted in readable:
            return wanted
        # A driver's packets lie beside the clouds that are made of them.
        clouds = [topic for topic in readable if types[topic] == CLOUD] or readable
        if wanted is None and len(clouds) == 1:
            return clouds[0]
        if wanted is None and clouds:
            raise ValueError(f"{self._path}: expected one topic of clouds, got {', '.join(clouds)}"
                             "; choose one with topic=")
        expected = "a topic of clouds" if wanted is None else f"clouds on {wanted}"
        found = ", ".join(f"{topic} ({types[topic]})" for topic in sorted(types)) or "nothing"
        raise ValueError(f"{self._path}: expected {expected}, got a recording of {found}; "
                         f"clouds are {', '.join(READABLE)}: record one of these")

    def _connections(self, recording: Recording) -> list[Any]:
        return [each for each in recording.connections
                if each.topic == self.topic and each.msgtype in READABLE]

    def _read_frames(self, recording: Recording, odometry: str | None) -> set[str]:
        """The frames that odometry places. Of one frame, named odometry goes before TF, TF before
        odometry."""
        if odometry is None:
            self._add_transforms(recording, set())
            return self._add_odometry(recording, None)
        own = self._add_odometry(recording, odometry)
        self._add_transforms(recording, own)
        return own

    def _add_transforms(self, recording: Recording, placed: set[str]) -> None:
        wanted = [each for each in recording.connections if each.msgtype == TRANSFORMS]
        for connection, _, raw in recording.messages(wanted):
            is_fixed = connection.topic.endswith("tf_static")
            for each in recording.deserialize(raw, connection).transforms:
                if each.child_frame_id.lstrip("/") not in placed:
                    pose = each.transform.translation, each.transform.rotation
                    add(self._frames, connection.topic, each.header, each.child_frame_id, pose,
                        is_fixed)

    def _add_odometry(self, recording: Recording, topic: str | None) -> set[str]:
        wanted = [each for each in recording.connections
                  if each.msgtype == ODOMETRY and topic in (None, each.topic)]
        if topic is not None and not wanted:
            raise ValueError(f"{self._path}: expected odometry on {topic}, got none")
        placed, topics = self._frames.children(), dict[str, set[str]]()
        for connection, _, raw in recording.messages(wanted):
            message = recording.deserialize(raw, connection)
            child = message.child_frame_id.lstrip("/")
            if child not in placed:
                topics.setdefault(child, set()).add(connection.topic)
                pose = message.pose.pose.position, message.pose.pose.orientation
                add(self._frames, connection.topic, message.header, child, pose)
        for child, names in topics.items():
            if len(names) > 1:
                self._frames.refuse(child, "expected one topic of odometry, got "
                                    f"{', '.join(sorted(names))}; choose one with odometry=")
        return set(topics)

    def _check_frames(self, recording: Recording, odometry: str | None, own: set[str]) -> None:
        """Tells at once, of the first cloud, that there will be no poses as they are asked for.

        Finds the sensor's frame where clouds are in the one that odometry places it in.
        """
        connection, _, raw = next(recording.messages(self._connections(recording)),
                                  (None, 0, b""))
        if connection is None:
            return
        header = recording.deserialize(raw, connection).header
        frame = header.frame_id.lstrip("/")
        above = self._frames.above(frame)
        below = [child for child in own if frame in self._frames.above(child)[1:]]
        if odometry is not None and own.isdisjoint(above) and len(below) == 1:
            self._sensor, = below
            above = self._frames.above(self._sensor)
        self._pose(0, header)
        there_are = f"; there are {', '.join(map(repr, self._frames.names())) or 'none'}"
        if self._frame is not None and self._frame not in above:
            raise ValueError(f"{self._path}: expected a frame above {frame!r}, got {self._frame!r}"
                             + there_are)
        if odometry is not None and own.isdisjoint(above):
            got = ", ".join(map(repr, sorted(own))) or "no messages"
            raise ValueError(f"{self._path}: expected odometry of {frame!r} or a frame above it, "
                             f"got {got} on {odometry}" + there_are)

    def _pose(self, index: int, header: Any) -> tuple[Matrix | None, str | None]:
        """The pose, or why the recording, which has poses of others, has none of this cloud."""
        time_ns = nanoseconds(header.stamp)
        if self._poses is not None:
            return self._poses.pose(index, time_ns * 1e-9), None
        if self._frames.is_empty():
            return None, None
        # Simulated time may begin with 0, but does not stay there.
        if time_ns == 0 and index > 0:
            return None, "its header has the time 0, so that nothing tells which pose is its own"
        frame = self._sensor or header.frame_id.lstrip("/")
        try:
            return self._frames.pose(frame, time_ns, self._frame), None
        except PoseMissing as missing:
            return None, str(missing)
        except ValueError as error:
            raise ValueError(f"{self._path}: {error}") from error

    def _in_cloud(self, sensor: str, header: Any) -> Matrix:
        """The sensor's pose in the frame of the cloud."""
        try:
            return self._frames.pose(sensor, nanoseconds(header.stamp), header.frame_id.lstrip("/"))
        except PoseMissing as missing:
            raise ValueError(f"{self._path}: {missing}") from missing

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Scan]:
        with self.reader() as recording:
            messages = recording.messages(self._connections(recording))
            for index, (connection, _, raw) in enumerate(messages):
                message = recording.deserialize(raw, connection)
                with naming(self._path, *OTHERWISE):
                    scan = self._scan(index, message, connection.msgtype)
                yield scan

    def _scan(self, index: int, message: Any, kind: str) -> Scan:
        try:
            fields = self._decoders[kind](message)
            count = len(next(iter(fields.values()))) if fields else 0
            points = points_of(fields, count)
        except ValueError as error:
            raise ValueError(f"{self._path}: message {index} of {self.topic}: {error}") from error
        pose, pose_missing = self._pose(index, message.header)
        if pose is None and are_of_a_map(points):
            (points, pose), pose_missing = told_from_middle(points, fields), None
        elif pose is not None and self._sensor is not None:
            points = told_from(points, fields, self._in_cloud(self._sensor, message.header))
        return Scan(
            name=f"{index:06}",
            points=points,
            pose=pose,
            pose_missing=pose_missing,
            time_s=nanoseconds(message.header.stamp) * 1e-9,
            fields=fields,
        )
