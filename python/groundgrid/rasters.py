"""GeoTIFFs through rasterio: the terrain of a drive, and other rasters with row 0 in the north.

    terrain = groundgrid.rasters.TerrainMosaic("terrain.tif", crs="EPSG:32632")
    for scan in scans:
        grid.process(scan.points, scan.pose)
        terrain.add(grid)
    terrain.finish()
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ._core import DriveTerrain, GroundGrid
from .datasets.extras import require
from .output_files import hidden_file

__all__ = ["NO_DATA", "TerrainMosaic", "open_raster"]

NO_DATA = -9999.0
BLOCK = 256
MOST_BLOCKS = 1_000_000
BANDS = ("height", "confidence", "count", "density", "standard deviation")
UNITS = ("m", "", "", "1/m2", "m")

StrPath = str | os.PathLike[str]


class TerrainMosaic:
    """The terrain of a drive as `groundgrid segment --terrain` writes it, as a GeoTIFF with bands
    height, confidence, count, density and standard deviation.

    path: the file to be. Its folder also holds what does not fit in memory.
    crs: of the map frame, as rasterio takes it; its x and y are metres. A local frame without.
    as_seen: gaps are not filled, and what stands out of the ground stays.

    Raises ValueError for a system that rasterio does not know or that is not in metres, and
    ImportError where rasterio is missing.
    """

    def __init__(self, path: StrPath, crs: str | None = None, as_seen: bool = False) -> None:
        self.path = Path(path)
        self._crs = checked_crs(crs)
        self._terrain = DriveTerrain(path, as_seen)

    def add(self, grid: GroundGrid) -> None:
        """Adds the map as it stands after the grid's last scan."""
        self._terrain.add(grid)

    @property
    def empty(self) -> bool:
        """Whether no scan showed any ground."""
        return self._terrain.empty

    def finish(self) -> None:
        """Writes the file, complete or not at all. Raises ValueError where there is no terrain."""
        if self.empty:
            raise ValueError(f"{self.path}: expected terrain to write, got a map in which no scan "
                             "has shown any ground")
        rows, columns = self._terrain.shape
        across, down = -(-columns // BLOCK), -(-rows // BLOCK)
        if across * down > MOST_BLOCKS:
            raise ValueError(f"{self.path}: expected a drive that one raster can hold, got "
                             f"{columns} x {rows} cells: check the poses for one that is far off")
        grid = {"shape": (rows, columns), "corner": self._terrain.corner_m,
                "cell_size": self._terrain.resolution_m, "crs": self._crs}
        with open_raster(self.path, bands=BANDS, units=UNITS, **grid) as raster:
            for row in range(down):
                for column in range(across):
                    self._write(raster, column, row, rows, columns)

    def _write(self, raster: Any, column: int, row: int, rows: int, columns: int) -> None:
        block = self._terrain.block(column, row)
        if block is None:
            return
        height, width = min(BLOCK, rows - row * BLOCK), min(BLOCK, columns - column * BLOCK)
        window = require("rasterio.windows", "geo", "writing a GeoTIFF").Window(
            column * BLOCK, row * BLOCK, width, height)
        raster.write(block[:, :height, :width], window=window)


def checked_crs(crs: str | None) -> Any:
    if crs is None:
        require("rasterio", "geo", "writing a GeoTIFF")
        return None
    known = known_crs(crs)
    if not known.is_projected or known.linear_units_factor[1] != 1.0:
        raise ValueError(f"crs: expected one whose x and y are metres, got {crs}")
    return known


def known_crs(crs: str, name: str = "crs") -> Any:
    """rasterio's CRS. Raises ValueError, with the name, where PROJ does not know it."""
    errors = require("rasterio.errors", "geo", "writing a GeoTIFF")
    try:
        return require("rasterio.crs", "geo", "writing a GeoTIFF").CRS.from_user_input(crs)
    except errors.CRSError as error:
        raise ValueError(f"{name}: expected one that PROJ knows, got {crs!r}: {error}") from error


@contextmanager
def open_raster(
    path: StrPath,
    *,
    shape: tuple[int, int],
    corner: tuple[float, float],
    cell_size: float,
    crs: Any,
    bands: Sequence[str],
    units: Sequence[str],
) -> Iterator[Any]:
    """rasterio's writer of a GeoTIFF of float32, which has its name once it is complete."""
    rasterio = require("rasterio", "geo", "writing a GeoTIFF")
    transform = require("rasterio.transform", "geo", "writing a GeoTIFF")
    with hidden_file(path) as hidden:
        try:
            with rasterio.open(
                hidden, "w", driver="GTiff", height=shape[0], width=shape[1], count=len(bands),
                dtype="float32", nodata=NO_DATA, crs=crs, compress="deflate", predictor=3,
                transform=transform.from_origin(*corner, cell_size, cell_size), tiled=True,
                blockxsize=BLOCK, blockysize=BLOCK, bigtiff="if_safer", sparse_ok=True,
            ) as raster:
                raster.descriptions = tuple(bands)
                raster.units = tuple(units)
                yield raster
        except rasterio.errors.RasterioError as error:
            raise OSError(f"{os.fspath(path)}: cannot be written: {error}") from error
