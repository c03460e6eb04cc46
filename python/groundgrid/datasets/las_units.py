"""Reference system and units of a LAS file."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .extras import require
from .laz_chunks import check_laz

# Places in the header of LAS, and what a record takes without its content.
MINOR_VERSION, VLR_COUNT, EVLR_COUNT, HEADER_1_4_BYTES = 25, 100, 243, 375
VLR_BYTES, EVLR_BYTES = 54, 60
MODEL, GEOGRAPHIC_SYSTEM = 1024, 2048
PROJECTED_SYSTEM, LENGTH_UNIT, VERTICAL_UNIT = 3072, 3076, 4099
USER_DEFINED = 32767
# Values of MODEL.
PROJECTED, GEOGRAPHIC, GEOCENTRIC = 1, 2, 3
DEGREES = "expected coordinates in metres or feet, got degrees: project it first"
UNITS_M = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937}


@dataclass(frozen=True)
class Units:
    """What a unit of the file's numbers is in metres, and the horizontal system."""

    horizontal_m: float
    vertical_m: float | None
    """None where nothing tells it and x and y are not in metres."""
    crs: Any
    """rasterio's CRS; None where the file names none that is known."""


@contextmanager
def las_errors(path: Path) -> Iterator[None]:
    """Names the file in errors of what is in it."""
    laspy = require("laspy", "geo", "reading LAS")
    lazrs = require("lazrs", "geo", "reading LAZ")
    try:
        yield
    except (laspy.LaspyException, lazrs.LazrsError, ValueError, OSError, EOFError, KeyError,
            IndexError, MemoryError, OverflowError, struct.error) as error:
        if isinstance(error, FileNotFoundError):
            raise
        raise ValueError(f"{path}: expected a LAS or LAZ file, got: {error}") from error
    except BaseException as error:
        # Of lazrs, which is in Rust; it is no Exception, and has no name to import.
        if type(error).__name__ != "PanicException":
            raise
        raise ValueError(f"{path}: expected a LAS or LAZ file, got one that is damaged: "
                         f"{error}") from error


@contextmanager
def open_las(path: Path) -> Iterator[Any]:
    """laspy's reader of a file."""
    laspy = require("laspy", "geo", "reading LAS")
    if not path.is_file():
        raise FileNotFoundError(f"{path}: expected a LAS or LAZ file, got nothing of that name")
    with las_errors(path):
        check_records(path)
        check_laz(path)
        reader = laspy.open(path)
    with reader:
        yield reader


def check_records(path: Path) -> None:
    """Raises ValueError where the header counts more records than the file can hold.

    laspy makes as many as are counted, behind the end of the file, too.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(HEADER_1_4_BYTES)
    if header[:4] != b"LASF":
        return  # laspy says so.
    counts = [(VLR_COUNT, VLR_BYTES)]
    if header[MINOR_VERSION : MINOR_VERSION + 1] >= b"\x04":
        counts.append((EVLR_COUNT, EVLR_BYTES))
    for place, least in counts:
        count = int.from_bytes(header[place : place + 4], "little")
        if count * least > size:
            raise ValueError(f"{count} records of {least} bytes and more in a file of {size} bytes")


def units_of(header: Any) -> Units:
    """By the WKT record, else by the GeoTIFF keys. Raises ValueError for degrees."""
    wkt = next((vlr.string for vlr in header.vlrs if hasattr(vlr, "string")
                and vlr.record_id == 2112 and vlr.user_id == "LASF_Projection"), "").strip("\0 ")
    keys = {key.id: key.value_offset for vlr in header.vlrs if hasattr(vlr, "geo_keys")
            for key in vlr.geo_keys if key.tiff_tag_location == 0}
    return units_by_wkt(wkt) if wkt else units_by_keys(keys)


def units_by_wkt(wkt: str) -> Units:
    crs = require("rasterio.crs", "geo", "reading LAS").CRS.from_wkt(horizontal_part(wkt))
    if crs.is_geographic:
        raise ValueError(DEGREES)
    horizontal_m = float(crs.linear_units_factor[1])
    vertical = re.search(r'VERT_?(?:CS|CRS)\[.*UNIT\["[^"]*",\s*([0-9.eE+-]+)', wkt, re.DOTALL)
    if vertical:
        return Units(horizontal_m, float(vertical[1]), crs)
    return Units(horizontal_m, 1.0 if horizontal_m == 1.0 else None, crs)


def horizontal_part(wkt: str) -> str:
    """The projected system of a compound one."""
    begin = re.search(r"PROJ(?:CS|CRS|ECTEDCRS)\[", wkt)
    if not begin:
        return wkt
    depth, quoted = 0, False
    for place in range(begin.start(), len(wkt)):
        letter = wkt[place]
        quoted ^= letter == '"'
        depth += 0 if quoted else (letter == "[") - (letter == "]")
        if depth == 0 and letter == "]" and not quoted:
            return wkt[begin.start() : place + 1]
    return wkt


def units_by_keys(keys: dict[int, int]) -> Units:
    rasterio = require("rasterio.crs", "geo", "reading LAS")
    if has_degrees(keys):
        raise ValueError(DEGREES)
    number = keys.get(PROJECTED_SYSTEM, USER_DEFINED)
    crs = None if number == USER_DEFINED else rasterio.CRS.from_epsg(number)
    horizontal_m = 1.0 if crs is None else float(crs.linear_units_factor[1])
    horizontal_m = UNITS_M.get(keys.get(LENGTH_UNIT, 0), horizontal_m)
    vertical_m = UNITS_M.get(keys.get(VERTICAL_UNIT, 0))
    if vertical_m is None and horizontal_m == 1.0:
        vertical_m = 1.0
    return Units(horizontal_m, vertical_m, crs)


def has_degrees(keys: dict[int, int]) -> bool:
    """By the model, else where the only system is one of latitude and longitude."""
    model = keys.get(MODEL)
    if model in (PROJECTED, GEOGRAPHIC, GEOCENTRIC):
        return model == GEOGRAPHIC
    return GEOGRAPHIC_SYSTEM in keys and PROJECTED_SYSTEM not in keys
