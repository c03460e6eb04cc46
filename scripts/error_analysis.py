#!/usr/bin/env python3
"""Where the errors of a segmentation lie, and how few there could be: the tables of
docs/accuracy.md.

    groundgrid segment DATA --output OUT
    python3 -m venv venv && venv/bin/pip install numpy
    venv/bin/python scripts/error_analysis.py DATA OUT --sequence 00 --sequence 03 ...

The ceiling is the greatest IoU that one threshold on the height above the true ground reaches: from
truth/height where there is one (simulated drives), else from the mean of each cell's own ground
points, no point of a cell without any being ground.
"""

import argparse
import pathlib

import numpy as np

from labelled_scans import (GROUND, PREDICTED_GROUND, iou, is_counted, is_ground, labels_of,
                            read_classes, read_points)

NAMES = {10: "car", 11: "bicycle", 13: "bus", 15: "motorcycle", 16: "on rails", 18: "truck",
         20: "other vehicle", 30: "person", 31: "bicyclist", 40: "road", 44: "parking",
         48: "sidewalk", 49: "other ground", 50: "building", 51: "fence", 52: "other structure",
         60: "lane marking", 71: "trunk", 72: "terrain", 80: "pole", 81: "traffic sign",
         99: "other object", 252: "moving car", 253: "moving bicyclist", 254: "moving person",
         255: "moving motorcyclist", 258: "moving truck", 259: "moving other vehicle"}
CELL_M = 0.33
THRESHOLDS_M = [0.04, 0.05, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4]
DISTANCES_M = [0, 5, 10, 20, 30, 50, 100]
HEIGHTS_M = [-10, -0.1, 0, 0.05, 0.1, 0.2, 0.3, 100]


def heights_over_truth(points, ground, truth):
    """Metres; infinite in a cell without ground."""
    if truth.exists():
        return np.fromfile(truth, np.float32).astype(float)
    cells = np.floor(points[:, :2].astype(float) / CELL_M).astype(np.int64)
    _, index = np.unique(cells[:, 0] * 1000000 + cells[:, 1], return_inverse=True)
    count = np.bincount(index, ground)
    total = np.bincount(index, ground * points[:, 2].astype(float))
    level = np.where(count > 0, total / np.maximum(count, 1), -np.inf)
    return points[:, 2] - level[index]


def read(data, predictions, sequence):
    """Per counted point of all scans: class, ground, predicted ground, distance, height."""
    folder = data / "sequences" / sequence
    parts = []
    for scan in sorted((folder / "velodyne").glob("*.bin")):
        points = read_points(scan)
        label = read_classes(labels_of(scan))
        predicted = read_classes(predictions / "sequences" / sequence / "predictions" /
                                 f"{scan.stem}.label")
        ground = is_ground(label)
        height = heights_over_truth(points, ground, folder / "truth" / "height" / f"{scan.stem}.f32")
        counted = is_counted(label)
        parts.append([values[counted] for values in
                      (label, ground, predicted == PREDICTED_GROUND,
                       np.hypot(points[:, 0], points[:, 1]), height)])
    return [np.concatenate(values) for values in zip(*parts)]


def print_by_bin(name, values, edges, errors, points):
    print(f"| {name} | false positives | false negatives |\n| --- | --- | --- |")
    for low, high in zip(edges, edges[1:]):
        inside = (values >= low) & (values < high)
        false_positive, false_negative = (100 * np.sum(kind & inside) / points for kind in errors)
        print(f"| {low:g} to {high:g} | {false_positive:.2f} | {false_negative:.2f} |")
    print()


def analyse(data, predictions, sequence):
    label, ground, predicted, distance, height = read(data, predictions, sequence)
    points = np.sum(ground)
    errors = (predicted & ~ground, ~predicted & ground)
    ceiling, threshold = max((iou(ground, height < limit), limit) for limit in THRESHOLDS_M)
    print(f"## {sequence}: IoU {iou(ground, predicted):.2f}, "
          f"ceiling {ceiling:.2f} at {threshold:g} m\n\nErrors in percent of the ground points.\n")
    print("| class | errors | of the class |\n| --- | --- | --- |")
    of_class = {c: np.sum((errors[0] | errors[1]) & (label == c)) for c in np.unique(label)}
    for c in sorted(of_class, key=of_class.get, reverse=True)[:8]:
        print(f"| {NAMES.get(c, c)}, {'ground' if c in GROUND else 'obstacle'} | "
              f"{100 * of_class[c] / points:.2f} | {100 * of_class[c] / np.sum(label == c):.1f} |")
    print()
    print_by_bin("distance, m", distance, DISTANCES_M, errors, points)
    print_by_bin("height over the true ground, m", height, HEIGHTS_M, errors, points)
    print(f"In cells without ground: {100 * np.sum(errors[0] & np.isinf(height)) / points:.2f}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("predictions", type=pathlib.Path, help="output folder of groundgrid segment")
    parser.add_argument("--sequence", action="append", required=True)
    arguments = parser.parse_args()
    for sequence in arguments.sequence:
        analyse(arguments.data, arguments.predictions, sequence)


if __name__ == "__main__":
    main()
