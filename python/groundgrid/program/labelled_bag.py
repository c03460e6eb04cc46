"""A recording once more, with the labelled clouds beside its own."""

from __future__ import annotations

import dataclasses
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import ScanResult
from ..datasets import BagDataset, Scan
from ..datasets.extras import require
from ..datasets.pointcloud2 import TYPES
from ..evaluation import to_semantic_kitti
from .clouds import records_of

SUFFIX = "/ground_grid"
DATATYPES = {np.dtype(name): number for number, name in TYPES.items()}


class LabelledBag:
    """Copies a recording, message by message, up to the end of each cloud that is labelled."""

    def __init__(self, reader: Any, writer: Any, topic: str) -> None:
        self._reader, self._writer, self._topic = reader, writer, topic
        self._connections = {id(each): copied(writer, each) for each in reader.connections}
        cloud = next(each for each in reader.connections if each.topic == topic)
        self._labelled = copied(writer, cloud, topic + SUFFIX)
        self._messages = iter(reader.messages())

    def add(self, scan: Scan, result: ScanResult) -> None:
        """The messages up to the next cloud, that cloud, and it with labels."""
        for connection, time_ns, raw in self._messages:
            self._writer.write(self._connections[id(connection)], time_ns, raw)
            if connection.topic == self._topic:
                message = self._reader.deserialize(raw, connection)
                self._writer.write(self._labelled, time_ns, self._bytes(message, scan, result))
                return

    def finish(self) -> None:
        """The messages behind the last cloud."""
        for connection, time_ns, raw in self._messages:
            self._writer.write(self._connections[id(connection)], time_ns, raw)

    def _bytes(self, message: Any, scan: Scan, result: ScanResult) -> Any:
        fields = {name: array for name, array in scan.fields.items()
                  if name not in ("label", "height_above_ground")}
        fields["label"] = to_semantic_kitti(result.labels)
        fields["height_above_ground"] = result.height_above_ground
        labelled = with_fields(message, records_of(fields), self._reader.typestore)
        store, name = self._reader.typestore, message.__msgtype__
        is_ros1 = not self._reader.is2
        return (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(labelled, name)


def with_fields(message: Any, records: npt.NDArray[Any], store: Any) -> Any:
    """The cloud with these records in place of its own."""
    kind = store.types["sensor_msgs/msg/PointField"]
    assert records.dtype.fields is not None and records.dtype.names is not None
    fields = []
    for name in records.dtype.names:
        each, offset = records.dtype.fields[name][:2]
        count = int(np.prod(each.shape, dtype=int))
        fields.append(kind(name, int(offset), DATATYPES[each.base], count))
    step = records.dtype.itemsize
    return dataclasses.replace(
        message, fields=fields, is_bigendian=False, point_step=step, row_step=step * message.width,
        data=records.view(np.uint8).reshape(-1),
    )


def copied(writer: Any, connection: Any, topic: str | None = None) -> Any:
    """The same connection in another recording."""
    name, text = topic or connection.topic, connection.msgdef.data
    if hasattr(connection.ext, "callerid"):
        return writer.add_connection(name, connection.msgtype, msgdef=text,
                                     md5sum=connection.digest, callerid=connection.ext.callerid,
                                     latching=connection.ext.latching)
    return writer.add_connection(name, connection.msgtype, msgdef=text, rihs01=connection.digest,
                                 serialization_format=connection.ext.serialization_format,
                                 offered_qos_profiles=connection.ext.offered_qos_profiles)


@contextmanager
def labelled_bag(dataset: BagDataset, path: Path) -> Iterator[LabelledBag]:
    """A recording of the same kind: a .bag file for ROS 1, else a folder with an MCAP file.

    It has its name once it is complete. Raises FileExistsError where there is a folder of that
    name.
    """
    if path.is_dir():
        raise FileExistsError(f"{path}: expected no recording of that name; take it away first")
    with dataset.reader() as reader:
        folder = Path(tempfile.mkdtemp(prefix=f".{path.name}.", dir=path.parent))
        try:
            hidden = folder / path.name
            with new_writer(reader, hidden) as writer:
                bag = LabelledBag(reader, writer, dataset.topic)
                yield bag
                bag.finish()
            os.replace(hidden, path)
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def new_writer(reader: Any, path: Path) -> Any:
    if not reader.is2:
        return require("rosbags.rosbag1", "bags", "writing a recording").Writer(path)
    rosbag2 = require("rosbags.rosbag2", "bags", "writing a recording")
    return rosbag2.Writer(path, version=9, storage_plugin=rosbag2.StoragePlugin.MCAP)
