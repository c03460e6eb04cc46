#!/usr/bin/env python3
"""One table over all data, for every change of the method: IoU of ground in percent on real scans of
four sensors and on simulated drives, and what one ghost return costs.

    scripts/yardstick.py path/to/groundgrid path/to/data --drives DRIVES \\
        --variant "paper=--preset paper" --variant "before=@path/to/older/groundgrid"

DRIVES is a folder of simulated drives in folders SCENE-SENSOR; those that are missing are made. A
variant is a row: flags of `groundgrid evaluate`, or @PROGRAM. Needs NumPy for the ghosts alone.
"""

import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

SCENES = ["urban", "hill", "motorway", "village", "offroad"]
SENSORS = ["hdl-64e", "hdl-32e", "vlp-16", "rosette"]
SCANS, SEED = 30, 3
# Title, folder, more flags. Single scans, but for those that have poses.
KITTI = ["--leave-unanswered-out"]
REAL = [("KITTI", "semantickitti", KITTI), ("KITTI single", "semantickitti", [*KITTI, "--single-scan"]),
        ("nuScenes", "other_sensors/nuscenes", ["--single-scan"]),
        ("front sector", "other_sensors/front_sector", ["--single-scan"]),
        ("argoverse2", "other_sensors/argoverse2", ["--single-scan"])]


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def evaluate(program, dataset, flags):
    """Mean IoU of the sequences, percent."""
    done = subprocess.run([program, "evaluate", dataset, "--json", *flags], capture_output=True,
                          text=True)
    if done.returncode != 0:
        sys.exit(f"yardstick.py: {dataset}: {done.stderr.strip()}")
    return mean(100.0 * row["iou"] for row in json.loads(done.stdout)["sequences"])


def make_drives(program, folder):
    for scene in SCENES:
        for sensor in SENSORS:
            drive = folder / f"{scene}-{sensor}"
            if not drive.exists():
                subprocess.run([program, "simulate", scene, drive, "--sensor", sensor, "--scans",
                                str(SCANS), "--seed", str(SEED)], check=True, capture_output=True)


def haunted(source, target):
    """A copy of a dataset with one return more in each scan: 15 to 58 m away, 3 to 30 m below the
    sensor. It has no label, so that it does not count itself."""
    import numpy as np

    random = np.random.default_rng(1)
    for scan in sorted(source.glob("sequences/*/velodyne/*.bin")):
        points = np.fromfile(scan, np.float32).reshape(-1, 4)
        labels = np.fromfile(scan.parent.parent / "labels" / f"{scan.stem}.label", np.uint32)
        away, angle, depth = random.uniform([15, 0, 3], [58, 2 * np.pi, 30])
        ghost = [[away * np.cos(angle), away * np.sin(angle), -depth, 0.0]]
        sequence = target / scan.parent.parent.relative_to(source)
        for name in ("velodyne", "labels"):
            (sequence / name).mkdir(parents=True, exist_ok=True)
        np.concatenate([points, np.float32(ghost)]).tofile(sequence / "velodyne" / scan.name)
        np.append(labels, np.uint32(0)).tofile(sequence / "labels" / f"{scan.stem}.label")


def ghost_loss(program, data, flags):
    """Points of IoU that a ghost in each scan costs, the worst mean of a sequence of any sensor."""
    losses = []
    for title, folder, set_flags in REAL:
        if "--single-scan" not in set_flags:
            continue
        with tempfile.TemporaryDirectory() as name:
            target = pathlib.Path(name)
            haunted(data / folder, target)
            both = [evaluate(program, dataset, [*set_flags, *flags])
                    for dataset in (data / folder, target)]
        losses.append(both[0] - both[1])
    return max(losses)


def row_of(program, flags, arguments):
    columns = {title: evaluate(program, arguments.data / folder, [*set_flags, *flags])
               for title, folder, set_flags in REAL}
    if arguments.ghosts:
        columns["ghosts cost"] = ghost_loss(program, arguments.data, flags)
    if arguments.drives:
        of_drive = {(scene, sensor): evaluate(program, arguments.drives / f"{scene}-{sensor}", flags)
                    for scene in SCENES for sensor in SENSORS}
        for scene in SCENES:
            columns[scene] = mean(of_drive[scene, sensor] for sensor in SENSORS)
        for sensor in SENSORS:
            columns[sensor] = mean(of_drive[scene, sensor] for scene in SCENES)
        columns["simulated"] = mean(of_drive.values())
    return columns


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--drives", type=pathlib.Path)
    parser.add_argument("--ghosts", action="store_true", help="adds what ghosts cost")
    parser.add_argument("--variant", action="append", default=[], metavar="NAME=FLAGS")
    arguments = parser.parse_args()
    if arguments.drives:
        make_drives(arguments.program, arguments.drives)
    heading = True
    for variant in ["default=", *arguments.variant]:
        name, _, flags = variant.partition("=")
        program, flags = (flags[1:], []) if flags.startswith("@") else (arguments.program,
                                                                       shlex.split(flags))
        columns = row_of(program, flags, arguments)
        if heading:
            print(f"| | {' | '.join(columns)} |\n| --- |" + " --- |" * len(columns))
        heading = False
        print(f"| {name} | {' | '.join(f'{value:.2f}' for value in columns.values())} |",
              flush=True)


if __name__ == "__main__":
    main()
