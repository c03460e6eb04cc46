"""What the commands have in common: the input, the method, the progress bar."""

from __future__ import annotations

import argparse
import ast
import operator
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tqdm import tqdm

from .. import datasets
from .._core import Config, parameters
from .map_coverage import MapCheck
from ..datasets import Dataset, Scan

# Options of loaders, by the name that the loader has for them.
LOADER_OPTIONS = {
    "sequence": "one of a dataset's sequences",
    "poses": "poses of the sensor, in KITTI's or TUM's form",
    "calibration": "calib.txt of camera poses, or a Velodyne's .yml",
    "topic": "that of a recording's clouds",
    "frame": "of a recording, that poses are in",
    "odometry": "topic of a recording to take poses from",
    "metadata": ".json of an Ouster",
    "sensor": "the number of one in a recording of several Ousters",
    "model": "of a Velodyne",
    "format": "kitti, nuscenes, pcd or ply, where the endings of files do not tell",
}


def add_input(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("input", metavar="INPUT", type=Path,
                        help="a dataset, a folder of scans, a scan or a recording")
    group = parser.add_argument_group("input")
    for name, text in LOADER_OPTIONS.items():
        group.add_argument(f"--{name}", help=text, type=int if name == "sensor" else str)
    group.add_argument("--scans", type=positive, metavar="N", help="only the first N")
    group.add_argument("--require-poses", action="store_true",
                       help="a scan without a pose is an error [it is taken as a single scan]")


def add_method(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("method")
    group.add_argument("--sensor-height-m", type=float, metavar="H",
                       help="of the sensor over the ground; else told by the first scan")
    group.add_argument("--preset", choices=("default", "paper"), default="default")
    group.add_argument("--config", type=Path, metavar="FILE.toml", help="parameters")
    group.add_argument("--set", action="append", default=[], metavar="NAME=VALUE",
                       help="one parameter; may be repeated")
    group.add_argument("--threads", type=positive, metavar="N", default=1)


def positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError
    return number


def open_input(options: argparse.Namespace) -> Dataset:
    """Raises ValueError where the loader has no such option."""
    given = {name: getattr(options, name) for name in LOADER_OPTIONS
             if getattr(options, name) is not None}
    try:
        return datasets.open(options.input, **given)
    except TypeError as error:
        names = ", ".join(f"--{name}" for name in given)
        raise ValueError(f"{options.input}: expected options that this kind of input has, got "
                         f"{names}: {error}") from error


def config_of(options: argparse.Namespace, **more: Any) -> Config:
    """Raises ValueError for parameters that there are not, or out of range."""
    config = Config.paper() if options.preset == "paper" else Config()
    if options.config is not None:
        config = Config.from_toml(options.config, preset=options.preset)
    known = {parameter.name for parameter in parameters()}
    values: dict[str, Any] = {}
    for given in options.set:
        name, sign, text = given.partition("=")
        if name not in known or not sign:
            raise ValueError(f"--set: expected NAME=VALUE with a parameter's name, got {given!r}")
        values[name] = value_of(text)
    if options.sensor_height_m is not None:
        values["sensor_height_m"] = options.sensor_height_m
    try:
        return config.replace(**(values | more))
    except TypeError as error:
        raise ValueError(f"--set: {error}") from error


class Inputs:
    """The files that are read, which nothing that is written may replace: scans, recordings, and
    those that options name."""

    def __init__(self, dataset: Dataset, options: argparse.Namespace) -> None:
        named = [options.input, options.config, options.poses, options.calibration,
                 options.metadata]
        # Where the metadata of an Ouster is found that are not named.
        named.append(options.input.with_suffix(".json"))
        files = [Path(file) for file in named if file is not None]
        files += [*getattr(dataset, "files", ()), *getattr(dataset, "beside", ())]
        self._known = {identity(file) for file in files if file.exists()}

    def keep(self, output: Path) -> None:
        """Raises ValueError where the output would take the place of one."""
        if output.exists() and identity(output) in self._known:
            raise ValueError(f"{output}: expected another file for --output than the input, which "
                             "it would replace")


def identity(file: Path) -> tuple[int, int]:
    """The same for all names and links of a file."""
    status = file.stat()
    return status.st_dev, status.st_ino


def value_of(text: str) -> Any:
    try:
        return ast.literal_eval({"true": "True", "false": "False"}.get(text, text))
    except (ValueError, SyntaxError):
        return text


def scans_of(dataset: Dataset, options: argparse.Namespace, config: Config) -> Iterator[Scan]:
    """The scans, with a progress bar where somebody may look at it, and words about odd ones."""
    total = operator.length_hint(dataset, 0)
    if options.scans is not None:
        total = min(total, options.scans) if total else options.scans
    bar = tqdm(total=total or None, unit="scan", leave=False, disable=None)
    poses, places = PoseCheck(options), MapCheck(options.input, config, warn)
    with bar:
        for number, scan in enumerate(dataset):
            if options.scans is not None and number >= options.scans:
                return
            poses.add(number, scan)
            places.add(scan)
            yield scan
            bar.update()


def warn(words: str) -> None:
    """On a line of its own, whatever the progress bar has written."""
    tqdm.write(f"groundgrid-py: warning: {words}", file=sys.stderr)


class PoseCheck:
    """Says once for each reason why scans have no pose; raises ValueError where they must have."""

    def __init__(self, options: argparse.Namespace) -> None:
        self._input, self._required = options.input, options.require_poses
        self._is_asked_for: bool = getattr(options, "single_scan", False)
        if self._required and self._is_asked_for:
            raise ValueError("--require-poses: expected without --single-scan, which uses no poses")
        self._told: set[str | None] = set()

    def add(self, number: int, scan: Scan) -> None:
        if scan.pose is not None or self._is_asked_for:
            return
        reason = scan.pose_missing
        time = "" if scan.time_s is None else f" of {scan.time_s:.3f} s"
        words = (f"{self._input}: scan {scan.name}{time} has no pose: "
                 f"{reason or 'the input has none'}")
        if self._required:
            raise ValueError(f"{words}; --poses FILE gives them")
        # A lone scan needs none.
        if reason in self._told or reason is None and number == 0:
            return
        self._told.add(reason)
        warn(f"{words}; this scan and any other of which that is true are taken as single scans "
             "(--poses FILE gives poses, --require-poses makes this an error)")
