#!/usr/bin/env python3
"""What a stop, a jump of the pose, a wrong roll, a wrong sensor height and missing scans do to the
labels of a drive: the table of docs/accuracy.md.

    groundgrid simulate urban DRIVE --scans 120 --seed 1
    python3 -m venv venv && venv/bin/pip install numpy
    venv/bin/python scripts/robustness.py path/to/groundgrid DRIVE

Each case is the drive with other poses, scans or flags; its IoU, scan by scan, stands beside that
of the same scans in the drive as it is.
"""

import argparse
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

from labelled_scans import PREDICTED_GROUND, iou, is_counted, is_ground, read_classes

EVENT = 60  # scan
RECOVERED = 0.5  # points of IoU
AVERAGED = 10  # scans


def moved(poses, first, x=0.0, y=0.0, z=0.0):
    """Poses of the left camera: x right, y down, z ahead."""
    result = poses.copy()
    result[first:, :, 3] += [x, y, z]
    return result


def rolled(poses, degrees):
    angle = np.radians(degrees)
    roll = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0],
                     [0, 0, 1]])
    result = poses.copy()
    result[:, :, :3] = poses[:, :, :3] @ roll
    return result


def cases(poses):
    """Name, scans of the drive in their order, poses, flags, the scan where it happens."""
    every = list(range(len(poses)))
    still = [0] * 100
    without = [i for i in every if not EVENT <= i < EVENT + 10]
    yield "standing still, 100 scans", still, poses[still], [], 0
    yield "pose jumps by 0.5 m to the side", every, moved(poses, EVENT, x=0.5), [], EVENT
    yield "pose jumps by 0.5 m ahead", every, moved(poses, EVENT, z=0.5), [], EVENT
    yield "pose jumps by 0.5 m up", every, moved(poses, EVENT, y=-0.5), [], EVENT
    yield "pose jumps by 0.5 m down", every, moved(poses, EVENT, y=0.5), [], EVENT
    yield "roll wrong by 2 degrees", every, rolled(poses, 2.0), [], 0
    for error in (-0.3, 0.3):
        yield (f"sensor height wrong by {error:+.1f} m", every, poses,
               ["--sensor-height-m", str(1.73 + error)], 0)
    yield "10 scans missing", without, poses[without], [], EVENT


def write_drive(source, folder, scans, poses):
    sequence = folder / "sequences" / "00"
    for name, suffix in (("velodyne", ".bin"), ("labels", ".label")):
        (sequence / name).mkdir(parents=True)
        for i, scan in enumerate(scans):
            (sequence / name / f"{i:06d}{suffix}").symlink_to(
                (source / name / f"{scan:06d}{suffix}").resolve())
    shutil.copy(source / "calib.txt", sequence)
    np.savetxt(sequence / "poses.txt", poses.reshape(-1, 12))


def labelled(program, source, scans, poses, flags):
    """IoU of each scan."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_drive(source, folder / "in", scans, poses)
        subprocess.run([program, "segment", folder / "in", "--output", folder / "out", *flags],
                       check=True, capture_output=True)
        result = []
        for i, scan in enumerate(scans):
            truth = read_classes(source / "labels" / f"{scan:06d}.label")
            answer = read_classes(folder / "out/sequences/00/predictions" / f"{i:06d}.label")
            counted = is_counted(truth)
            result.append(iou(is_ground(truth)[counted], answer[counted] == PREDICTED_GROUND))
        return np.array(result)


def scans_until_recovered(reached, expected):
    """The first scan from which on ten together are as good as they were, nearly."""
    lost = expected - reached
    for first in range(len(lost) - AVERAGED + 1):
        if lost[first:first + AVERAGED].mean() <= RECOVERED:
            return first
    return "never"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("drive", type=pathlib.Path, help="a simulated drive of 80 scans or more")
    arguments = parser.parse_args()
    source = arguments.drive / "sequences" / "00"
    poses = np.loadtxt(source / "poses.txt").reshape(-1, 3, 4)
    as_it_is = labelled(arguments.program, source, list(range(len(poses))), poses, [])
    print("| case | IoU | as it is | lowest | scans until recovered |\n| --- | --- | --- | --- | --- |")
    for name, scans, other_poses, flags, event in cases(poses):
        reached = labelled(arguments.program, source, scans, other_poses, flags)[event:]
        expected = as_it_is[scans][event:]
        print(f"| {name} | {reached.mean():.2f} | {expected.mean():.2f} | {reached.min():.2f} | "
              f"{scans_until_recovered(reached, expected)} |", flush=True)


if __name__ == "__main__":
    main()
