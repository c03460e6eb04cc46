"""Labelled clouds: PCD and PLY with all fields of the scan, and LAS."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import chain, count
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._core import Label, ScanResult, write_cloud
from ..datasets import LasDataset, Scan
from ..datasets.extras import require
from ..datasets.las_units import las_errors, open_las
from ..evaluation import to_semantic_kitti
from ..output_files import hidden_file

# ASPRS: never classified, ground, unclassified, low noise.
ASPRS = {Label.UNKNOWN: 0, Label.GROUND: 2, Label.OBSTACLE: 1, Label.OUTLIER: 7}
LAS_STEP_M = 0.001
# From the middle of the points. LAS has 32-bit integers, which hold 2147 km in such steps, and two
# points are up to twice this apart.
LAS_REACH_M = 1e6
# What takes the place of types that clouds have not.
FILE_TYPES = {"b1": np.dtype("u1"), "f2": np.dtype("f4")}
# What write_cloud() puts behind the fields of the scan, in place of any of these names.
ANSWERS = frozenset({"label", "height_above_ground"})
Fields = Mapping[str, npt.NDArray[Any]]
Places = npt.NDArray[np.float64]


def without_blanks(names: Iterable[str]) -> list[str]:
    """Names as the headers of PCD and PLY can hold them, which are split at blanks; all different.

    A name that has no blanks stays, and a number sets another one apart from it.
    """
    given = list(names)
    taken = ANSWERS.union(given)
    changed = []
    for name in given:
        # Not "_", which is the name of padding in PCD.
        base = "_".join(name.split()) or "unnamed"
        if base != name:
            others = (f"{base}_{number}" for number in count(2))
            name = next(each for each in chain([base], others) if each not in taken)
            taken |= {name}
        changed.append(name)
    return changed


def records_of(fields: Fields) -> npt.NDArray[Any]:
    """Packed records with all fields, in their order."""
    types = [(name, FILE_TYPES.get(array.dtype.str[1:], array.dtype.newbyteorder("=")),
              array.shape[1:]) for name, array in fields.items()]
    records = np.zeros(len(next(iter(fields.values()))), types)
    for name, array in fields.items():
        records[name] = array
    return records


def write_pcl(path: Path, scan: Scan, result: ScanResult) -> None:
    """A PCD or PLY file, by its ending; complete or not at all."""
    records = records_of(scan.fields)
    assert records.dtype.names is not None
    fields = []
    for name, place in zip(without_blanks(records.dtype.names), records.dtype.names):
        kind = records.dtype[place]
        fields.append((name, str(kind.base), int(np.prod(kind.shape, dtype=int))))
    # The bytes of a point are said, as none can be worked out from no points.
    packed = records.view(np.uint8).reshape(len(records), records.dtype.itemsize)
    write_cloud(path, path.suffix[1:], fields, packed, to_semantic_kitti(result.labels),
                result.height_above_ground)


def write_las(path: Path, scan: Scan, result: ScanResult, source: Path | None) -> None:
    """A LAS or LAZ file with the ASPRS classes; complete or not at all.

    That of a LAS file is the same file with other classes; of other scans points are in the map
    frame where the pose is known, else in the sensor's, and those that LAS cannot hold, not finite
    or 1000 km and more off the others, are left out.
    """
    laspy = require("laspy", "geo", "writing LAS")
    classes = np.zeros(len(result.labels), np.uint8)
    for label, number in ASPRS.items():
        classes[result.labels == label] = number
    heights = result.height_above_ground
    if source is not None:
        with open_las(source) as reader, las_errors(source):
            las = reader.read()
    else:
        places = map_places(scan)
        held = held_by_las(places)
        las = new_las(laspy, places[held], scan.points[held, 3])
        classes, heights = classes[held], heights[held]
    if "height_above_ground" not in las.point_format.dimension_names:
        las.add_extra_dim(laspy.ExtraBytesParams("height_above_ground", "float32", "metres"))
    las.classification = classes
    las.height_above_ground = heights
    lazrs = require("lazrs", "geo", "writing LAZ")
    try:
        # To a path laspy writes by its ending, which the hidden one has not.
        with hidden_file(path) as hidden, hidden.open("wb+") as file:
            las.write(file, do_compress=path.suffix == ".laz")
    except (laspy.LaspyException, lazrs.LazrsError, OSError) as error:
        raise OSError(f"{path}: cannot be written: {error}") from error


def map_places(scan: Scan) -> Places:
    """x, y, z in the map frame where the pose is known, else in the sensor's; NaN stays NaN."""
    places = scan.points[:, :3].astype(np.float64)
    # Infinity times a rotation's zeros would warn.
    places[~np.isfinite(places).all(axis=1)] = np.nan
    return places if scan.pose is None else places @ scan.pose[:3, :3].T + scan.pose[:3, 3]


def held_by_las(places: Places) -> npt.NDArray[np.bool_]:
    """Which are finite and no farther from the middle one than LAS reaches."""
    finite: npt.NDArray[np.bool_] = np.logical_and.reduce(np.isfinite(places), axis=1)
    if not finite.any():
        return finite
    # The median, as the mean goes wherever a single wrong point is.
    middle = np.median(places[finite], axis=0)
    close = np.abs(places - middle) < LAS_REACH_M
    near: npt.NDArray[np.bool_] = np.logical_and.reduce(close, axis=1)
    return near


def new_las(laspy: Any, places: Places, intensity: npt.NDArray[np.float32]) -> Any:
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales = np.full(3, LAS_STEP_M)
    header.offsets = np.floor(np.median(places, axis=0)) if len(places) else np.zeros(3)
    las = laspy.LasData(header)
    las.x, las.y, las.z = places.T
    las.intensity = np.clip(np.nan_to_num(intensity), 0, 65535).astype(np.uint16)
    return las


def source_of(dataset: object, number: int) -> Path | None:
    """The LAS file that the scan of this number is."""
    return dataset.files[number] if isinstance(dataset, LasDataset) else None
