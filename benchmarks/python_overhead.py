#!/usr/bin/env python3
"""What a call from Python costs more than the same call from C++: a whole scan, one thread, one core.

    make bench-python DATA=path/to/dataset

Both process the tenth scan of SemanticKITTI 00 over and over, on the map that the ten scans have
left: the C++ call is the case warm/standard of groundgrid_benchmarks, the one from Python has
float32 points without gaps and out=. Both come from build/bench, with one library. Each repetition
is a pair of new processes, the other one first each time, with as many calls in the second as the
first; the cost is the median of the pairs' differences.
"""

import argparse
import itertools
import json
import multiprocessing
import os
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = ROOT / "build/bench/benchmarks/groundgrid_benchmarks"
CASE = "^warm/standard/kilopoints:124/threads:1/"
SOURCE = "SemanticKITTI 00"
SCANS = 10
LIMIT_SHARE, LIMIT_MS = 0.05, 0.1

sys.path.insert(0, str(ROOT / "build/bench/python"))


class CannotMeasure(Exception):
    """Why, and what to do."""


def dataset():
    """Where groundgrid_benchmarks looks, too."""
    data = pathlib.Path(os.environ.get("GROUNDGRID_DATA") or ROOT.parent / "shared/data")
    for folder in (data / "semantickitti", data):
        if (folder / "sequences/00/velodyne").is_dir():
            return folder
    raise CannotMeasure(f"{data}: expected sequences/00 of SemanticKITTI; say where with DATA=")


def time_cpp():
    """Milliseconds a call, the calls, and the points of the scan."""
    run = subprocess.run([PROGRAM, f"--benchmark_filter={CASE}", "--benchmark_format=json"],
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
    (found,) = json.loads(run.stdout)["benchmarks"]
    if found["label"] != SOURCE:
        raise CannotMeasure(f"{PROGRAM.name} timed a scan of '{found['label']}', not of {SOURCE}")
    return found["real_time"], found["iterations"], int(found["points"])


def time_python(folder, calls, expected_points):
    """Milliseconds a call."""
    import groundgrid
    import numpy as np

    grid = groundgrid.GroundGrid(sensor_height_m=1.73, threads=1)
    for scan in itertools.islice(groundgrid.datasets.open(folder, sequence="00"), SCANS):
        grid.process(scan.points, scan.pose)
    points, pose = scan.points, scan.pose
    if len(points) != expected_points:
        raise CannotMeasure(f"C++ timed {expected_points} points, Python would {len(points)}")
    assert points.dtype == np.float32 and points.flags.c_contiguous
    out = np.empty(len(points), np.uint8), np.empty(len(points), np.float32)
    begin = time.perf_counter()
    for _ in range(calls):
        grid.process(points, pose, out=out)
    return 1000 * (time.perf_counter() - begin) / calls


def time_python_anew(*arguments):
    """In a process of its own, as the C++ call is."""
    with multiprocessing.get_context("spawn").Pool(1) as process:
        return process.apply(time_python, arguments)


def measure(folder, repetitions):
    """Milliseconds of the C++ call and of the one from Python, pair by pair; the points."""
    _, calls, points = time_cpp()
    pairs = []
    for repetition in range(repetitions):
        if repetition % 2 == 0:
            cpp = time_cpp()[0]
            python = time_python_anew(folder, calls, points)
        else:
            python = time_python_anew(folder, calls, points)
            cpp = time_cpp()[0]
        pairs.append((cpp, python))
    return pairs, points


def report(pairs, points):
    """Prints the medians; whether Python costs no more than it may."""
    for name, times in zip(("C++", "Python"), zip(*pairs)):
        print(f"{name:>6}  {statistics.median(times):.3f} ms, {min(times):.3f} to {max(times):.3f}")
    cpp = statistics.median(pair[0] for pair in pairs)
    cost = statistics.median(python - cpp for cpp, python in pairs)
    limit = max(LIMIT_SHARE * cpp, LIMIT_MS)
    print(f"Python costs {cost:.3f} ms ({100 * cost / cpp:.1f} %) more, of {limit:.3f} ms allowed; "
          f"{points} points, {len(pairs)} pairs")
    return cost <= limit


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repetitions", type=int, default=11, help="pairs of runs [11]")
    options = parser.parse_args()
    # The last core: the first one serves most interrupts. What is started later is there, too.
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    try:
        return 0 if report(*measure(dataset(), options.repetitions)) else 1
    except (CannotMeasure, OSError, subprocess.CalledProcessError) as error:
        print(f"python_overhead.py: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
