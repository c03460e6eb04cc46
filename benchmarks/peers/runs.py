"""Runs one method over one sequence: labels in SemanticKITTI layout and a time for each scan."""

import csv
import dataclasses
import json
import pathlib
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

from labelled_scans import PREDICTED_GROUND, read_points

from package_peers import silenced
from sequences import ComparisonError

PREDICTED_NON_GROUND = 99
YARDSTICK_BYTES = 8 << 20


@dataclasses.dataclass
class ScanTime:
    """Milliseconds; None where it is not known."""
    call: float | None = None  # from NumPy to NumPy
    cpu: float | None = None  # of the call, all threads
    own: float | None = None  # of the method alone


def predictions_folder(output, sequence):
    return output / "sequences" / sequence.name / "predictions"


def run_peer(make_peer, sequence, output):
    """In this process; every point gets an answer."""
    folder = predictions_folder(output, sequence)
    folder.mkdir(parents=True, exist_ok=True)
    times = []
    with silenced():
        peer = make_peer(sequence.sensor_height_m)
        for scan in sequence.scans:
            points = read_points(scan)
            cpu, begin = time.process_time(), time.perf_counter()
            answer = peer.segment(points)
            end, cpu_end = time.perf_counter(), time.process_time()
            times.append(ScanTime(1000 * (end - begin), 1000 * (cpu_end - cpu), answer.own_ms))
            labels = np.where(answer.ground, PREDICTED_GROUND, PREDICTED_NON_GROUND)
            labels.astype(np.uint32).tofile(folder / f"{scan.stem}.label")
    return times


def call_program(command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise ComparisonError(f"{' '.join(map(str, command))} failed:\n{done.stderr.strip()}")
    return done.stdout


def run_program(program, flags, sequence, output):
    """`groundgrid segment`, which writes the milliseconds of each scan itself."""
    call_program([program, "segment", sequence.dataset, "--sequence", sequence.name, "--output",
                  output, "--threads", "1", *flags])
    with open(output / "timing.csv", newline="") as file:
        return [ScanTime(own=float(row["milliseconds"])) for row in csv.DictReader(file)
                if row["sequence"] == sequence.name]


def add_package_times(times, sequence, paper, single_scan):
    """Adds those of the same method called from Python, in this process, as the peers are. Where
    the package cannot be loaded they stay unknown."""
    try:
        import groundgrid
    except ImportError:
        return times
    config = groundgrid.Config.paper() if paper else groundgrid.Config()
    grid = groundgrid.GroundGrid(config, threads=1, sensor_height_m=sequence.sensor_height_m)
    scans = groundgrid.datasets.open(sequence.dataset, sequence=sequence.name)
    for scan, scan_time in zip(scans, times, strict=True):
        if single_scan:
            grid.reset()
        cpu, begin = time.process_time(), time.perf_counter()
        grid.process(scan.points, scan.pose)
        end, cpu_end = time.perf_counter(), time.process_time()
        scan_time.call, scan_time.cpu = 1000 * (end - begin), 1000 * (cpu_end - cpu)
    return times


def evaluate(program, sequence, predictions):
    """The figures of `groundgrid evaluate`, one judge for all."""
    report = call_program([program, "evaluate", sequence.dataset, "--sequence", sequence.name,
                           "--predictions", predictions, "--leave-unanswered-out", "--json"])
    return json.loads(report)["sequences"][0]


def yardstick_ms():
    """To copy 8 MB within memory: what the machine does at this moment."""
    source = np.ones(YARDSTICK_BYTES, np.uint8)
    target = np.empty_like(source)
    times = []
    for _ in range(11):
        begin = time.perf_counter()
        np.copyto(target, source)
        times.append(1000 * (time.perf_counter() - begin))
    return float(np.median(times))
