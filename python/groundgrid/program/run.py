"""groundgrid-py run: labels, labelled clouds, the terrain and a labelled recording."""

from __future__ import annotations

import argparse
import json
import time
from collections import Counter
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .. import __version__
from .._core import Config, GroundGrid, Label, ScanResult, write_labels
from ..datasets import BagDataset, Dataset, FileDataset, Scan
from ..evaluation import to_semantic_kitti
from ..output_files import clean_folder, hidden_file, locked_folder, remove_file
from ..rasters import TerrainMosaic, checked_crs
from .clouds import source_of, write_las, write_pcl
from .labelled_bag import LabelledBag, labelled_bag
from .options import Inputs, add_input, add_method, config_of, open_input, scans_of, warn

CLOUDS = ("pcd", "ply", "las", "laz")
Matrix = npt.NDArray[np.float64]


def add_to(commands: Any) -> None:
    parser = commands.add_parser(
        "run", help="labels of every point, labelled clouds, the terrain",
        description="Segments whatever a loader reads and writes, below --output: NAME.label (of a "
        "dataset sequences/NN/predictions/NAME.label), one uint32 a point: 40 ground, 99 obstacle, "
        "1 outlier, 0 unknown; what else is asked for; and run.json, last of all.",
    )
    add_input(parser)
    add_method(parser)
    group = parser.add_argument_group("output")
    group.add_argument("--output", type=Path, required=True, metavar="DIR")
    group.add_argument("--clouds", choices=CLOUDS, action="append", default=[],
                       help="NAME.pcd or .ply with labels and heights beside all fields, or .las or "
                       ".laz with ASPRS classes; may be repeated")
    group.add_argument("--terrain", action="store_true", help="terrain.tif of the drive, and "
                       "NAME.tif of each scan that has no pose")
    group.add_argument("--crs", help="of the terrain, e.g. EPSG:32632 [a local frame]")
    group.add_argument("--bag", action="store_true",
                       help="the recording once more, with the labelled clouds")
    group.add_argument("--single-scan", action="store_true",
                       help="forget the map before each scan, and use no poses")
    parser.set_defaults(command=run)


def run(options: argparse.Namespace) -> None:
    if options.crs is not None and not options.terrain:
        raise ValueError("--crs: expected together with --terrain")
    dataset = open_input(options)
    if options.bag and not isinstance(dataset, BagDataset):
        raise ValueError(f"--bag: expected a recording, got {options.input}")
    config = config_of(options)
    folder = place_of(dataset, options.output)
    inputs = Inputs(dataset, options)
    for each in (options.output / "run.json", folder / "terrain.tif"):
        inputs.keep(each)
    with locked_folder(options.output):
        # What it marks as complete is not yet there.
        remove_file(options.output / "run.json")
        with ExitStack() as stack:
            output = Output(dataset, folder, inputs, options, stack)
            summary = segment(dataset, config, output, options)
        summary |= {"version": __version__, "input": str(options.input), "config": config.to_dict()}
        with hidden_file(options.output / "run.json") as hidden:
            hidden.write_text(json.dumps(summary, indent=2) + "\n")
    counts, scans = summary["counts"], summary["scans"]
    shares = ", ".join(f"{name} {100 * count / max(1, sum(counts.values())):.1f} %"
                       for name, count in counts.items())
    alone = f" ({summary['single_scans']} of them single)" if summary["single_scans"] else ""
    print(f"{options.output}: {scans} scans{alone}, {shares}, {summary['median_ms']:.1f} ms a scan")


def place_of(dataset: Dataset, output: Path) -> Path:
    """Where the sequence's own files go."""
    name = dataset.name if isinstance(dataset, FileDataset) else ""
    return output / "sequences" / name if name else output


def segment(
    dataset: Dataset, config: Config, output: Output, options: argparse.Namespace
) -> dict[str, Any]:
    grid = GroundGrid(config, threads=options.threads)
    counts, times_ms = np.zeros(len(Label), np.int64), []
    missing: Counter[str] = Counter()
    for number, scan in enumerate(scans_of(dataset, options, config)):
        pose = None if options.single_scan else scan.pose
        if pose is None:
            grid.reset()
            missing[why_alone(scan, options)] += 1
        begin = time.perf_counter()
        result = processed(grid, scan, pose, options.input)
        times_ms.append(1000 * (time.perf_counter() - begin))
        counts += np.bincount(result.labels, minlength=len(Label))
        output.add(number, scan, result)
        output.add_terrain(scan.name, grid, is_placed=pose is not None)
    if not times_ms:
        raise ValueError(f"{options.input}: expected scans, got none")
    if counts.sum() == 0:
        warn(f"{options.input}: none of {len(times_ms)} scans has any point")
    elif counts.sum() == counts[Label.UNKNOWN]:
        raise ValueError(f"{options.input}: expected ground or obstacles, got no answer for any of "
                         f"{counts.sum()} points in {len(times_ms)} scans: all are without a "
                         "return, not finite, too near or outside of the map")
    output.finish()
    return {
        "scans": len(times_ms),
        "single_scans": missing.total(),
        "single_scans_because": dict(missing),
        "counts": {label.name.lower(): int(counts[label]) for label in Label},
        "median_ms": float(np.median(times_ms)),
        "sensor_height_m": result.sensor_height_m,
        "sensor_height_estimated": result.sensor_height_estimated,
    }


def why_alone(scan: Scan, options: argparse.Namespace) -> str:
    if options.single_scan:
        return "--single-scan"
    return scan.pose_missing or "the input has no pose of it"


def processed(grid: GroundGrid, scan: Scan, pose: Matrix | None, path: Path) -> ScanResult:
    try:
        return grid.process(scan.points, pose)
    except ValueError as error:
        raise ValueError(f"{path}: scan {scan.name}: {error}") from error


class Output:
    """Everything that is written of a run but its record."""

    def __init__(
        self, dataset: Dataset, folder: Path, inputs: Inputs, options: argparse.Namespace,
        stack: ExitStack,
    ) -> None:
        self._dataset, self._clouds = dataset, options.clouds
        self._is_sequence = folder != options.output
        self._labels = folder / "predictions" if self._is_sequence else folder
        self._folder = folder / "clouds" if self._is_sequence else folder
        self._input, self._inputs = options.input.resolve(), inputs
        for each in (folder, self._labels, *([self._folder] if self._clouds else [])):
            clean_folder(each)
        self._terrains = folder if options.terrain else None
        self._crs = options.crs
        if options.terrain:
            checked_crs(options.crs)
        self._drive: TerrainMosaic | None = None
        self._has_terrain = False
        self._bag: LabelledBag | None = None
        if options.bag and isinstance(dataset, BagDataset):
            name = options.input.stem + "_labelled"
            ending = ".bag" if options.input.suffix == ".bag" else ""
            inputs.keep(folder / (name + ending))
            self._bag = stack.enter_context(labelled_bag(dataset, folder / (name + ending)))

    def add(self, number: int, scan: Scan, result: ScanResult) -> None:
        labels = self._labels / f"{scan.name}.label"
        self._inputs.keep(labels)
        write_labels(labels, to_semantic_kitti(result.labels))
        for ending in self._clouds:
            path = self._folder / f"{scan.name}.{ending}"
            if self._input == path.resolve().parent:
                raise ValueError(f"{path}: expected another folder for --output than the input's")
            self._inputs.keep(path)
            if ending in ("las", "laz"):
                write_las(path, scan, result, source_of(self._dataset, number))
            else:
                write_pcl(path, scan, result)
        if self._bag is not None:
            self._bag.add(scan, result)

    def add_terrain(self, name: str, grid: GroundGrid, is_placed: bool) -> None:
        """To the drive's, or where nobody knows where the scan was taken as one of its own."""
        if self._terrains is None:
            return
        if is_placed:
            if self._drive is None:
                self._drive = TerrainMosaic(self._terrains / "terrain.tif", self._crs)
            self._drive.add(grid)
            return
        path = self._terrains / f"{name}.tif"
        self._inputs.keep(path)
        lone = TerrainMosaic(path, self._crs)
        lone.add(grid)
        if not lone.empty:
            lone.finish()
            self._has_terrain = True

    def finish(self) -> None:
        if self._drive is not None:
            self._drive.finish()
        elif self._terrains is not None and not self._has_terrain:
            raise ValueError(f"{self._terrains}: expected terrain to write, got no scan that shows "
                             "any ground")
