"""A recording once more, with the labelled clouds beside its own."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import ScanResult
from ..datasets import BagDataset, Scan
from ..datasets.bags import Recording
from ..datasets.cloud_messages import CLOUD, CLOUD_FIELD
from ..datasets.extras import require
from ..datasets.pointcloud2 import TYPES
from ..evaluation import to_semantic_kitti
from ..output_files import hidden_folder
from .clouds import records_of

SUFFIX = "/ground_grid"
DATATYPES = {np.dtype(name): number for number, name in TYPES.items()}


class LabelledBag:
    """Copies a recording, message by message, up to the end of each cloud that is labelled."""

    def __init__(self, recording: Recording, writer: Any, topic: str) -> None:
        self._recording, self._writer, self._topic = recording, writer, topic
        known, store = known_of(recording), recording.typestore
        self._connections = {id(each): copied(writer, each, store) for each in known}
        cloud = next(each for each in known if each.topic == topic)
        self._labelled = labelled_connection(writer, cloud, store, topic + SUFFIX)
        self._messages = recording.messages(known)

    def add(self, scan: Scan, result: ScanResult) -> None:
        """The messages up to the next cloud, that cloud, and it with labels."""
        for connection, time_ns, raw in self._messages:
            self._writer.write(self._connections[id(connection)], time_ns, raw)
            if connection.topic == self._topic:
                message = self._recording.deserialize(raw, connection)
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
        store = self._recording.typestore
        labelled = with_fields(message, records_of(fields), store)
        is_ros1 = not self._recording.is2
        return (store.serialize_ros1 if is_ros1 else store.serialize_cdr)(labelled, CLOUD)


def with_fields(message: Any, records: npt.NDArray[Any], store: Any) -> Any:
    """The cloud with these records in place of its own; a PointCloud2 in place of another type."""
    kind = store.types[CLOUD_FIELD]
    assert records.dtype.fields is not None and records.dtype.names is not None
    fields = []
    for name in records.dtype.names:
        each, offset = records.dtype.fields[name][:2]
        count = int(np.prod(each.shape, dtype=int))
        fields.append(kind(name, int(offset), DATATYPES[each.base], count))
    step = records.dtype.itemsize
    is_cloud = message.__msgtype__ == CLOUD
    height, width = (message.height, message.width) if is_cloud else (1, len(records))
    return store.types[CLOUD](
        header=message.header, height=height, width=width, fields=fields, is_bigendian=False,
        point_step=step, row_step=step * width, data=records.view(np.uint8).reshape(-1),
        is_dense=is_cloud and message.is_dense,
    )


def known_of(recording: Recording) -> list[Any]:
    """The connections whose types can be written: by their definition, or as one of ROS's own.

    Names the others. ROS 2 bags in SQLite before Iron have no definitions.
    """
    known = []
    for each in recording.connections:
        if each.msgdef.data or each.msgtype in recording.typestore.fielddefs:
            known.append(each)
        else:
            print(f"groundgrid-py: {recording.path}: {each.topic} is left out of the labelled "
                  f"recording: there is no definition of {each.msgtype}", file=sys.stderr)
    return known


def copied(writer: Any, connection: Any, store: Any, topic: str | None = None) -> Any:
    """The same connection in another recording."""
    name, text = topic or connection.topic, connection.msgdef.data
    if hasattr(connection.ext, "callerid"):
        return writer.add_connection(name, connection.msgtype, msgdef=text,
                                     md5sum=connection.digest, callerid=connection.ext.callerid,
                                     latching=connection.ext.latching)
    # Where older recordings have no definition or no digest, rosbags makes both of the store's.
    return writer.add_connection(name, connection.msgtype, typestore=store, msgdef=text or None,
                                 rihs01=connection.digest or None,
                                 serialization_format=connection.ext.serialization_format,
                                 offered_qos_profiles=connection.ext.offered_qos_profiles)


def labelled_connection(writer: Any, connection: Any, store: Any, topic: str) -> Any:
    """Of PointCloud2, which a recording of another type of clouds does not define."""
    if connection.msgtype == CLOUD:
        return copied(writer, connection, store, topic)
    typesys = require("rosbags.typesys", "bags", "writing a recording")
    ros = typesys.get_typestore(typesys.Stores.LATEST)
    store.register({name: ros.fielddefs[name] for name in (CLOUD, CLOUD_FIELD)
                    if name not in store.fielddefs})
    return writer.add_connection(topic, CLOUD, typestore=store)


@contextmanager
def labelled_bag(dataset: BagDataset, path: Path) -> Iterator[LabelledBag]:
    """A recording of the same kind: a .bag file for ROS 1, else a folder with an MCAP file.

    It has its name once it is complete. Raises FileExistsError where there is a folder of that
    name, and ValueError where the recording is a labelled one already.
    """
    if path.is_dir():
        raise FileExistsError(f"{path}: expected no recording of that name; take it away first")
    with dataset.reader() as recording:
        check_unlabelled(recording, dataset.topic)
        with hidden_folder(path) as hidden:
            with new_writer(recording, hidden) as writer:
                bag = LabelledBag(recording, writer, dataset.topic)
                yield bag
                bag.finish()


def check_unlabelled(recording: Recording, topic: str) -> None:
    if any(each.topic == topic + SUFFIX for each in recording.connections):
        raise ValueError(f"{recording.path}: expected no topic {topic + SUFFIX}, where the "
                         f"labelled clouds of {topic} go, got one: take the recording as it was "
                         "before, or another topic")


def new_writer(recording: Recording, path: Path) -> Any:
    if not recording.is2:
        return require("rosbags.rosbag1", "bags", "writing a recording").Writer(path)
    rosbag2 = require("rosbags.rosbag2", "bags", "writing a recording")
    return rosbag2.Writer(path, version=9, storage_plugin=rosbag2.StoragePlugin.MCAP)
