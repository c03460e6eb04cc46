#!/usr/bin/env python3
"""Figures of labelled drives in SemanticKITTI layout, real or simulated, as docs/simulation.md shows
them: what the scans are like and how hard their ground is.

    python3 -m venv venv && venv/bin/pip install numpy pypatchworkpp==1.4.1
    venv/bin/python scripts/simulation_figures.py DATASET/sequences/00 OTHER/sequences/03 ...

Without pypatchworkpp its row is left out.
"""

import argparse
import pathlib

import numpy as np

from labelled_scans import GROUND, is_counted, is_ground, labels_of, read_classes, read_points

try:
    import pypatchworkpp
except ImportError:
    pypatchworkpp = None

CLASSES = {"ground": GROUND, "leaves (70)": [70], "buildings (50)": [50], "fences (51)": [51],
           "vehicles": [10, 18, 20, 252, 258, 259], "outliers (1)": [1], "unlabeled (0)": [0]}
RANGES_M = [0, 4, 6, 8, 10, 15, 20, 30, 40, 60, 80.5]
ELEVATIONS_DEG = [-30, -20, -15, -10, -8, -6, -4, -2, 0, 4]
DISTANCES_M = [0, 5, 10, 20, 30, 45]
CELL_M = 0.33


def shares(values, edges):
    return np.histogram(values, edges)[0] / len(values)


def deviations(points, ground):
    """Standard deviation of the heights in each cell of ground alone, in cm, by distance."""
    cells = np.floor(points[:, :2].astype(float) / CELL_M).astype(np.int64)
    _, index, count = np.unique(cells[:, 0] * 10000 + cells[:, 1], return_inverse=True,
                                return_counts=True)

    def mean(values):
        return np.bincount(index, values) / count

    z = points[:, 2].astype(float)
    deviation = 100 * np.sqrt(np.maximum(mean(z * z) - mean(z) ** 2, 0))
    distance = mean(np.hypot(points[:, 0], points[:, 1]))
    usable = (count >= 3) & (mean(ground.astype(float)) == 1)
    return [deviation[usable & (distance >= low) & (distance < high)]
            for low, high in zip(DISTANCES_M, DISTANCES_M[1:])]


def ransac_plane(points, random):
    """Within 0.2 m of the plane, no steeper than 37 degrees, that fits most points."""
    places = points[:, :3].astype(float)
    best, most = np.zeros(len(places), bool), -1
    for _ in range(100):
        a, b, c = places[random.integers(0, len(places), 3)]
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal)
        if length < 1e-6 or abs(normal[2]) < 0.8 * length:
            continue
        near = np.abs((places[::10] - a) @ normal) < 0.2 * length
        if near.sum() > most:
            most, best = near.sum(), np.abs((places - a) @ normal) < 0.2 * length
    return best


class Iou:
    """Of ground; outliers, leaves and what is unlabeled are not counted."""

    def __init__(self):
        self.hits = self.union = 0

    def add(self, predicted, labels):
        counted = is_counted(labels)
        truth = is_ground(labels)
        self.hits += (predicted & truth & counted).sum()
        self.union += ((predicted | truth) & counted).sum()

    def text(self):
        return f"{100 * self.hits / self.union:.2f}"


def patchwork(sensor_height):
    parameters = pypatchworkpp.Parameters()
    parameters.verbose = False
    parameters.sensor_height = sensor_height
    return pypatchworkpp.patchworkpp(parameters)


def figures(sequence, sensor_height):
    """Rows of name and text."""
    scans = sorted((sequence / "velodyne").glob("*.bin"))
    random = np.random.default_rng(0)
    method = patchwork(sensor_height) if pypatchworkpp else None
    peer, plane = Iou(), Iou()
    all_labels, ranges, elevations, spread = [], [], [], []
    for scan in scans:
        points, labels = read_points(scan), read_classes(labels_of(scan))
        all_labels.append(labels)
        ranges.append(np.linalg.norm(points[:, :3], axis=1))
        elevations.append(np.degrees(np.arcsin(points[:, 2] / ranges[-1])))
        spread.append(deviations(points, is_ground(labels)))
        plane.add(ransac_plane(points, random), labels)
        if method:
            method.estimateGround(points)
            ground = np.zeros(len(points), bool)
            ground[np.asarray(method.getGroundIndices(), int)] = True
            peer.add(ground, labels)
    labels = np.concatenate(all_labels)
    rows = [("scans", str(len(scans))), ("points a scan", f"{len(labels) / len(scans):.0f}")]
    rows += [(name, f"{np.isin(labels, of).mean():.4f}") for name, of in CLASSES.items()]
    for title, values, edges in (("range, m", ranges, RANGES_M),
                                 ("elevation, deg", elevations, ELEVATIONS_DEG)):
        rows += [(f"{title}: {low} to {high}", f"{share:.3f}") for low, high, share in
                 zip(edges, edges[1:], shares(np.concatenate(values), edges))]
    for i, (low, high) in enumerate(zip(DISTANCES_M, DISTANCES_M[1:])):
        cells = np.concatenate([of_scan[i] for of_scan in spread])
        rows.append((f"deviation in ground cells, {low} to {high} m, cm: 50, 90, 99 %",
                     " ".join(f"{x:.1f}" for x in np.percentile(cells, [50, 90, 99]))
                     if len(cells) else "-"))
    if method:
        rows.append(("IoU of Patchwork++ 1.4.1", peer.text()))
    return rows + [("IoU of a RANSAC plane", plane.text())]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sequences", nargs="+", type=pathlib.Path,
                        help="folders with velodyne/ and labels/")
    parser.add_argument("--sensor-height-m", type=float, default=1.73)
    options = parser.parse_args()
    for sequence in options.sequences:
        if not list((sequence / "velodyne").glob("*.bin")):
            parser.error(f"{sequence} has no velodyne/*.bin")
    columns = [figures(sequence, options.sensor_height_m) for sequence in options.sequences]
    print("| | " + " | ".join(str(sequence) for sequence in options.sequences) + " |")
    print("| --- |" + " --- |" * len(columns))
    for row in zip(*columns):
        print(f"| {row[0][0]} | " + " | ".join(text for _, text in row) + " |")


if __name__ == "__main__":
    main()
