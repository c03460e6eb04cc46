"""Scans and labels in SemanticKITTI layout, and IoU as docs/evaluation.md defines it: what the
scripts beside this one and benchmarks/peers share."""

import numpy as np

GROUND = [40, 44, 48, 49, 60, 72]
NOT_COUNTED = [0, 1, 70]
PREDICTED_GROUND = 40  # as `groundgrid segment` writes it


def read_points(scan):
    """N × 4: x, y, z and intensity."""
    return np.fromfile(scan, np.float32).reshape(-1, 4)


def read_classes(file):
    """One a point; the number of the instance is left out."""
    return np.fromfile(file, np.uint32) & 0xFFFF


def labels_of(scan):
    """The file with the labels of SEQUENCE/velodyne/NAME.bin."""
    return scan.parent.parent / "labels" / f"{scan.stem}.label"


def is_ground(classes):
    return np.isin(classes, GROUND)


def is_counted(classes):
    return ~np.isin(classes, NOT_COUNTED)


def iou(ground, predicted):
    """Of counted points, percent."""
    return 100 * np.sum(ground & predicted) / np.sum(ground | predicted)
