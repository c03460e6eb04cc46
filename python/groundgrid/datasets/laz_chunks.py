"""What a LAZ file promises, held against its size before it is decoded.

lazrs takes the memory that the file asks for, and ends the program if it is not there.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, BinaryIO

from .extras import require

# Places in the LASzip record, and the compressor whose chunks are made of layers.
COMPRESSOR, ITEM_COUNT, ITEMS = 0, 32, 34
LAYERED = 3
# Layers of an item by its type; extra bytes have one each.
LAYERS = {10: 9, 11: 1, 12: 2, 13: 1}
EXTRA_BYTES = 14
# Scans shrink to a tenth; a thousandth would be one point over and over.
MOST_TIMES_SMALLER = 1000
# Any file may take them, however small: a chunk has room for 50000 points even if there are fewer.
FREE_BYTES = 1 << 26


def check_laz(path: Path) -> None:
    """Raises ValueError where a LAZ file promises more than it can hold; others pass."""
    laspy = require("laspy", "geo", "reading LAZ")
    lazrs = require("lazrs", "geo", "reading LAZ")
    with path.open("rb") as file:
        header = laspy.LasHeader.read_from(file)
        if not header.are_points_compressed:
            return
        records = header.vlrs.get("LasZipVlr")
        if len(records) != 1:
            raise ValueError(f"{len(records)} LASzip records, of which there must be one")
        record = bytes(records[0].record_data)
        vlr = lazrs.LazVlr(record)
        size, begin = path.stat().st_size, header.offset_to_point_data
        end = check_chunk_count(file, begin, size, vlr.item_size())
        file.seek(begin)
        chunks = lazrs.read_chunk_table(file, vlr)
        points = sum(points for points, _ in chunks)
        room = max(points, header.point_count, 0 if vlr.uses_variable_size_chunks()
                   else vlr.chunk_size())
        if room * vlr.item_size() > max(FREE_BYTES, size * MOST_TIMES_SMALLER):
            raise ValueError(f"{room} points in a file of {size} bytes")
        if sum(taken for _, taken in chunks) > end - begin:
            raise ValueError(f"chunks of more than the {end - begin} bytes before their table")
        if points < header.point_count:
            raise ValueError(f"chunks of fewer than {header.point_count} points")
        if struct.unpack_from("<H", record, COMPRESSOR)[0] == LAYERED:
            check_layers(file, begin + 8, [taken for _, taken in chunks], record, vlr)


def check_chunk_count(file: BinaryIO, begin: int, size: int, point_bytes: int) -> int:
    """Where the table of chunks begins. Each chunk has its first point as it is."""
    file.seek(begin)
    end, = struct.unpack("<q", file.read(8).ljust(8, b"\0"))
    if end == -1:  # written by a program that could not go back
        file.seek(size - 8)
        end, = struct.unpack("<q", file.read(8))
    if not begin + 8 <= end <= size - 8:
        raise ValueError(f"a table of chunks at byte {end} of {size}")
    file.seek(end)
    _, count = struct.unpack("<II", file.read(8))
    if count * point_bytes > end - begin:
        raise ValueError(f"{count} chunks in {end - begin} bytes")
    return int(end)


def check_layers(file: BinaryIO, begin: int, chunks: list[int], record: bytes, vlr: Any) -> None:
    """Behind the first point of a chunk are their number and the bytes of each layer."""
    count, = struct.unpack_from("<H", record, ITEM_COUNT)
    items = [struct.unpack_from("<HH", record, ITEMS + 6 * each) for each in range(count)]
    layers = sum(size if kind == EXTRA_BYTES else LAYERS[kind] for kind, size in items)
    head = vlr.item_size() + 4
    for taken in chunks:
        file.seek(begin + head)
        sizes = struct.unpack(f"<{layers}I", file.read(4 * layers).ljust(4 * layers, b"\0"))
        if head + 4 * layers + sum(sizes) > taken:
            raise ValueError(f"a chunk of {taken} bytes with layers of {sum(sizes)}")
        begin += taken
