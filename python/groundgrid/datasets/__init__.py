"""Scans from files, datasets and recordings, as arrays that GroundGrid takes.

    for scan in groundgrid.datasets.open("path/to/recording"):
        grid.process(scan.points, scan.pose)

`open()` chooses the loader by what is on disk: `FileDataset` for KITTI, SemanticKITTI, nuScenes,
PCD and PLY, `BagDataset` for ROS 1 and ROS 2 bags and MCAP files.
"""

from ._open import open_dataset as open
from .bags import BagDataset
from .files import FileDataset
from .scan import Scan

__all__ = ["BagDataset", "FileDataset", "Scan", "open"]
