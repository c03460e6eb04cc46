"""groundgrid-py rasterize: the ground of a classified airborne tile as a reference GeoTIFF."""

from __future__ import annotations

import argparse
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from tqdm import tqdm

from ..datasets.las_units import UNITS_M, Units, las_errors, open_las, units_of
from ..rasters import NO_DATA, known_crs, open_raster

GROUND = 2
POINTS_AT_ONCE = 1_000_000
MOST_CELLS = 400_000_000
UNITS = {"m": UNITS_M[9001], "ft": UNITS_M[9002], "us-ft": UNITS_M[9003]}


def add_to(commands: Any) -> None:
    parser = commands.add_parser(
        "rasterize", help="the ground of an airborne tile, for groundgrid evaluate-terrain",
        description="Averages the heights of an airborne tile's ground points on a grid, as section "
        "IV-C of the paper does: the reference of groundgrid evaluate-terrain. The raster has the "
        "tile's reference system, and heights in metres.",
    )
    parser.add_argument("tile", type=Path, metavar="TILE.laz", help="LAS or LAZ, classified")
    parser.add_argument("--output", type=Path, metavar="FILE.tif", help="[TILE.tif, here]")
    parser.add_argument("--cell-m", type=float, default=0.5, help="metres [0.5]")
    parser.add_argument("--class", type=int, action="append", dest="classes", metavar="NUMBER",
                        help=f"ASPRS class of the ground; may be repeated [{GROUND}]")
    parser.add_argument("--height-unit", choices=UNITS, help="where the tile does not tell it")
    parser.add_argument("--crs", help="where the tile names none, e.g. EPSG:2903; units as there. "
                        "The tile's own wins")
    parser.set_defaults(command=rasterize)


def rasterize(options: argparse.Namespace) -> None:
    if not options.cell_m > 0:
        raise ValueError(f"--cell-m: expected metres, more than 0, got {options.cell_m:g}")
    output = options.output or Path(options.tile.with_suffix(".tif").name)
    if output.exists() and options.tile.exists() and output.samefile(options.tile):
        raise ValueError(f"{output}: expected another file for --output than the tile")
    crs = system_given(options)
    with open_las(options.tile) as reader:
        with las_errors(options.tile):
            units = units_of(reader.header)
        units = units_given(units, crs, options)
        with las_errors(options.tile):
            sums = HeightSums.over(reader.header, options.cell_m / units.horizontal_m)
        classes = np.array(options.classes or [GROUND])
        with tqdm(total=reader.header.point_count, unit="point", unit_scale=True, leave=False,
                  disable=None) as bar, las_errors(options.tile):
            for points in reader.chunk_iterator(POINTS_AT_ONCE):
                sums.add(points, classes)
                bar.update(len(points))
    if not sums.counts.any():
        raise ValueError(f"{options.tile}: expected points of class "
                         f"{' or '.join(map(str, classes))}, got none")
    assert units.vertical_m is not None
    sums.write(output, units.vertical_m, units.crs)
    share = np.count_nonzero(sums.counts) / sums.counts.size
    print(f"{output}: {sums.counts.shape[1]} x {sums.counts.shape[0]} cells of {options.cell_m:g} m,"
          f" {100 * share:.1f} % with a height, from {int(sums.counts.sum())} ground points")


def system_given(options: argparse.Namespace) -> Any:
    """rasterio's CRS of --crs; None without it. Raises ValueError where it is none of a map."""
    if options.crs is None:
        return None
    crs = known_crs(options.crs, "--crs")
    if crs.is_geographic:
        raise ValueError(f"--crs: expected a system in metres or feet, got degrees: {options.crs}")
    return crs


def units_given(units: Units, given_crs: Any, options: argparse.Namespace) -> Units:
    """With what the command line says where the tile does not."""
    crs, horizontal_m, vertical_m = units.crs, units.horizontal_m, units.vertical_m
    if given_crs is not None and crs is None:
        crs = given_crs
        horizontal_m = float(crs.linear_units_factor[1])
        vertical_m = 1.0 if horizontal_m == 1.0 else vertical_m
    if options.height_unit is not None:
        vertical_m = UNITS[options.height_unit]
    if vertical_m is None:
        raise ValueError(f"{options.tile}: expected the unit of the heights, got none, with x and y "
                         f"in units of {horizontal_m:g} m: say it with --height-unit")
    return Units(horizontal_m, vertical_m, crs)


@dataclass
class HeightSums:
    """Sums of heights on a grid, row 0 in the north, in the units of the tile."""

    bounds: npt.NDArray[np.float64]
    """Of the header: west and south, east and north."""
    cell: float
    corner_cell: npt.NDArray[np.int64]
    """That of west and south; cell 0 begins at 0."""
    heights: npt.NDArray[np.float64]
    counts: npt.NDArray[np.uint32]

    @staticmethod
    def over(header: Any, cell: float) -> HeightSums:
        """Edges lie on multiples of the cell, so that tiles side by side fit together."""
        bounds = np.array([header.mins[:2], header.maxs[:2]], np.float64)
        first, last = np.floor(bounds / cell)
        # A point on the eastern or northern edge belongs to the cell beyond.
        columns, rows = last - first + 1
        if not (columns > 0 and rows > 0 and columns * rows <= MOST_CELLS):
            raise ValueError(f"bounds of {columns:.0f} x {rows:.0f} cells, of which {MOST_CELLS} "
                             "would be possible")
        shape = int(rows), int(columns)
        return HeightSums(bounds, cell, first.astype(np.int64), np.zeros(shape),
                          np.zeros(shape, np.uint32))

    def add(self, points: Any, classes: npt.NDArray[Any]) -> None:
        chosen = np.isin(np.asarray(points.classification), classes)
        if hasattr(points, "withheld"):
            chosen &= np.asarray(points.withheld) == 0
        row, column = self._cells_of(points, chosen)
        cells, places = np.unique(row * self.counts.shape[1] + column, return_inverse=True)
        heights = np.asarray(points.z)[chosen]
        self.heights.reshape(-1)[cells] += np.bincount(places, heights, len(cells))
        self.counts.reshape(-1)[cells] += np.bincount(places, minlength=len(cells)).astype(np.uint32)

    def _cells_of(
        self, points: Any, chosen: npt.NDArray[np.bool_]
    ) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """Rows and columns, by the same division as that of the bounds: others round otherwise."""
        places = np.stack([np.asarray(points.x)[chosen], np.asarray(points.y)[chosen]], axis=1)
        held = np.clip(places, *self.bounds)
        # Programs round the bounds of the header; less than a step of the file is no other place.
        places = np.where(np.abs(places - held) < points.scales[:2], held, places)
        column, north = (np.floor(places / self.cell).astype(np.int64) - self.corner_cell).T
        rows, columns = self.counts.shape
        if not ((0 <= north) & (north < rows) & (0 <= column) & (column < columns)).all():
            raise ValueError("points outside of the bounds that the header has")
        return rows - 1 - north, column

    def write(self, path: str | os.PathLike[str], vertical_m: float, crs: Any) -> None:
        known = self.counts > 0
        means = np.full(known.shape, NO_DATA, np.float32)
        means[known] = self.heights[known] / self.counts[known] * vertical_m
        west, south = map(int, self.corner_cell)
        corner = west * self.cell, (south + len(known)) * self.cell
        with open_raster(path, shape=known.shape, corner=corner, cell_size=self.cell,
                         crs=crs, bands=("height", "count"), units=("m", "")) as raster:
            raster.write(means, 1)
            raster.write(self.counts.astype(np.float32), 2)
