"""A recording: what is ahead of the vehicle in each of its clouds.

    python examples/python/bag.py [RECORDING [TOPIC]]

RECORDING is a ROS 1 or ROS 2 bag or an MCAP file; without it one is made of a simulated drive.
Needs groundgrid[bags]. `groundgrid-py run RECORDING --bag --output DIR` writes the recording once
more with labelled clouds.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

import groundgrid
from groundgrid import Label

AHEAD_M, TO_THE_SIDE_M = 30.0, 1.5


def cloud_of(types, scan):
    """x, y, z, intensity as sensor_msgs/PointCloud2."""
    stamp = types["builtin_interfaces/msg/Time"](int(scan.time_s), int(scan.time_s % 1 * 1e9))
    field = types["sensor_msgs/msg/PointField"]
    data = np.ascontiguousarray(scan.points).view(np.uint8).reshape(-1)
    return types["sensor_msgs/msg/PointCloud2"](
        header=types["std_msgs/msg/Header"](stamp, "lidar"),
        height=1,
        width=len(scan.points),
        fields=[field(name, 4 * i, 7, 1) for i, name in enumerate(("x", "y", "z", "intensity"))],
        is_bigendian=False,
        point_step=16,
        row_step=data.size,
        data=data,
        is_dense=True,
    )


def simulate(path):
    """A ROS 2 bag in an MCAP file."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    with Writer(path, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        name = "sensor_msgs/msg/PointCloud2"
        connection = writer.add_connection("/points", name, typestore=store)
        for scan in groundgrid.simulation.Drive("urban", "hdl-32e", scans=5):
            data = store.serialize_cdr(cloud_of(store.types, scan), name)
            writer.write(connection, int(scan.time_s * 1e9), data)


def tell(recording, topic=None):
    dataset = groundgrid.datasets.BagDataset(recording, topic=topic)
    grid = groundgrid.GroundGrid()
    for scan in dataset:
        # Without odometry or TF each cloud is a scan of its own.
        if scan.pose is None:
            grid.reset()
        labels, heights = grid.process(scan.points, scan.pose)
        x, y = scan.points[:, 0], scan.points[:, 1]
        in_the_way = ((labels == Label.OBSTACLE) & (heights < 2.5) & (2.0 < x) & (x < AHEAD_M)
                      & (np.abs(y) < TO_THE_SIDE_M))
        nearest = f"{x[in_the_way].min():.1f} m" if in_the_way.any() else "nothing"
        print(f"{dataset.topic} at {scan.time_s:.2f} s: {nearest} ahead")


def main(arguments):
    if arguments:
        return tell(*arguments)
    with tempfile.TemporaryDirectory() as folder:
        simulate(Path(folder) / "drive")
        tell(Path(folder) / "drive")


if __name__ == "__main__":
    main(sys.argv[1:])
