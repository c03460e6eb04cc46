"""Scans from files, datasets and recordings, as arrays that GroundGrid takes.

    for scan in groundgrid.datasets.open("path/to/recording"):
        grid.process(scan.points, scan.pose)

`open()` chooses the loader by what is on disk: `FileDataset` for KITTI, SemanticKITTI, nuScenes,
PCD and PLY, `BagDataset` for ROS 1 and ROS 2 bags and MCAP files, `ArrayDataset` for NumPy's files,
`LasDataset` for LAS and LAZ, `VelodyneDataset` and `OusterDataset` for packet captures. All take
poses= from a file in KITTI's or TUM's form.
"""

from ._open import Dataset
from ._open import open_dataset as open
from .arrays import ArrayDataset
from .bags import BagDataset
from .files import FileDataset, sequence_names
from .las import LasDataset
from .ouster import OusterDataset
from .scan import Scan
from .velodyne import VelodyneDataset

__all__ = [
    "ArrayDataset",
    "BagDataset",
    "Dataset",
    "FileDataset",
    "LasDataset",
    "OusterDataset",
    "Scan",
    "VelodyneDataset",
    "open",
    "sequence_names",
]
