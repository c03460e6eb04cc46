"""groundgrid-py compare: the method beside the open peers that are installed, on the same scans."""

from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import Config, GroundGrid, Label, estimate_sensor_height
from ..datasets import Scan
from ..evaluation import SegmentationMetrics, to_semantic_kitti
from ..peers import PEERS, Peer, PeerMissing
from .native_output import silenced
from .options import add_input, add_method, config_of, open_input, scans_of

GROUND, NON_GROUND = 40, 99
# For a peer that is only made to see whether it is installed.
ANY_HEIGHT_M = 1.7


def add_to(commands: Any) -> None:
    parser = commands.add_parser(
        "compare", help="beside the open peers that are installed",
        description="Runs the method, default and paper, and each open peer that is installed over "
        "the same scans on one thread, in turns, and prints what share is ground, how often each "
        "agrees with the default and, where the scans have true labels, the paper's figures, in "
        "percent; and milliseconds. make peers measures with more care: docs/benchmarks.md.",
    )
    add_input(parser)
    add_method(parser)
    parser.add_argument("--methods", help="names with commas between them [all that there are]")
    parser.add_argument("--json", action="store_true", help="prints JSON instead of a table")
    parser.set_defaults(command=compare)


class Ours:
    """The method with its memory."""

    def __init__(self, config: Config, threads: int) -> None:
        self._grid = GroundGrid(config, threads=threads)

    def labels(self, scan: Scan) -> npt.NDArray[np.uint32]:
        if scan.pose is None:
            self._grid.reset()
        return to_semantic_kitti(self._grid.process(scan.points, scan.pose).labels)


class Theirs:
    """A peer, which sees each scan by itself."""

    def __init__(self, peer: Peer) -> None:
        self._peer = peer

    def labels(self, scan: Scan) -> npt.NDArray[np.uint32]:
        places = scan.points[:, :3]
        # As the method has it: rays without a return are no points.
        seen = np.isfinite(places).all(axis=1) & places.any(axis=1)
        labels = np.zeros(len(scan.points), np.uint32)
        ground = self._peer.segment(np.ascontiguousarray(scan.points[seen])).ground
        labels[seen] = np.where(ground, GROUND, NON_GROUND)
        return labels


class Score:
    """What is counted of one method."""

    def __init__(self, method: Ours | Theirs) -> None:
        self.method = method
        self.times_ms: list[float] = []
        self.points = self.ground = self.agreed = 0
        self.metrics: SegmentationMetrics | None = None

    def run(self, scan: Scan) -> npt.NDArray[np.uint32]:
        begin = time.perf_counter()
        labels = self.method.labels(scan)
        self.times_ms.append(1000 * (time.perf_counter() - begin))
        return labels

    def add(
        self, scan: Scan, labels: npt.NDArray[np.uint32], ours: npt.NDArray[np.uint32]
    ) -> None:
        answered = (labels != 0) & (ours != 0)
        self.points += int(answered.sum())
        self.ground += int(((labels == GROUND) & answered).sum())
        self.agreed += int((((labels == GROUND) == (ours == GROUND)) & answered).sum())
        if scan.labels is not None:
            self.metrics = self.metrics or SegmentationMetrics()
            self.metrics.add_scan(scan.points, scan.labels, labels)

    def figures(self) -> dict[str, float]:
        found = {"ground": 100 * self.ground / max(1, self.points),
                 "agrees": 100 * self.agreed / max(1, self.points)}
        if self.metrics is not None:
            report = self.metrics.report(leave_unanswered_out=True)
            found |= {name: 100 * (report[name] or 0.0)
                      for name in ("iou", "precision", "recall", "f1")}
        return found | {"median_ms": float(np.median(self.times_ms)),
                        "p95_ms": float(np.percentile(self.times_ms, 95))}


def compare(options: argparse.Namespace) -> None:
    # Before a peer's libraries are loaded.
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, str(options.threads))
    config = config_of(options)
    names = chosen(options.methods)
    scores: dict[str, Score] = {}
    missing: list[str] = []
    for number, scan in enumerate(scans_of(open_input(options), options, config)):
        with silenced():
            if number == 0:
                scores, missing = made(names, scan, config, options)
            run_all(scores, scan, number)
    if not scores:
        raise ValueError(f"{options.input}: expected scans, got none")
    figures = {name: score.figures() for name, score in scores.items()}
    print(json.dumps(figures, indent=2) if options.json else table(figures))
    if missing and not options.json:
        print(f"\nNot installed: {', '.join(missing)}; "
              "pip install -r benchmarks/peers/requirements.txt")


def chosen(given: str | None) -> list[str]:
    every = ["groundgrid", "groundgrid paper", *PEERS]
    if given is None:
        return every
    names = [name.strip() for name in given.split(",") if name.strip()]
    for name in names:
        if name not in every:
            raise ValueError(f"--methods: expected some of {', '.join(every)}, got {name!r}")
    return names


def made(
    names: Iterable[str], scan: Scan, config: Config, options: argparse.Namespace
) -> tuple[dict[str, Score], list[str]]:
    """A method of each name, and the names of those that are not installed."""
    height_m = config.sensor_height_m or estimate_sensor_height(scan.points, config)
    paper = Config.paper().replace(sensor_height_m=config.sensor_height_m)
    # Ours is always run, since the others are held against it.
    scores = {"groundgrid": Score(Ours(config, options.threads))}
    missing = []
    for name in names:
        if name == "groundgrid paper":
            scores[name] = Score(Ours(paper, options.threads))
        if name not in PEERS:
            continue
        try:
            peer = PEERS[name](ANY_HEIGHT_M if height_m is None else height_m)
        except PeerMissing:
            if options.methods is not None:
                raise
            missing.append(name)
            continue
        if height_m is None:
            raise ValueError(f"{scan.name}: the scan does not tell how high the sensor is: say it "
                             "with --sensor-height-m")
        scores[name] = Score(Theirs(peer))
    return scores, missing


def run_all(scores: dict[str, Score], scan: Scan, number: int) -> None:
    """Another method is the first with each scan, so that none always follows the same one."""
    names = list(scores)
    begin = number % len(names)
    labels = {name: scores[name].run(scan) for name in names[begin:] + names[:begin]}
    for name in names:
        scores[name].add(scan, labels[name], labels["groundgrid"])


def table(figures: dict[str, dict[str, float]]) -> str:
    titles = {"ground": "ground %", "agrees": "as ours %", "iou": "IoU", "precision": "precision",
              "recall": "recall", "f1": "F1", "median_ms": "ms", "p95_ms": "ms, 95th pct."}
    columns = list(next(iter(figures.values())))
    first = max(len(name) for name in figures)
    widths = {each: max(6, len(titles[each])) for each in columns}
    lines = [" ".join([" " * first, *(titles[each].rjust(widths[each]) for each in columns)])]
    for name, values in figures.items():
        cells = (f"{values[each]:.2f}".rjust(widths[each]) for each in columns)
        lines.append(" ".join([name.ljust(first), *cells]))
    return "\n".join(lines)
