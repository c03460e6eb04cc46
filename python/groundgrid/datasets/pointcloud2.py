"""ROS's PointCloud2, with any layout of its fields."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

# sensor_msgs/PointField
TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def fields_of(message: Any) -> dict[str, npt.NDArray[Any]]:
    """Every field of the points by name, in the order of the message, row after row.

    Raises ValueError where the message is not what it says of itself.
    """
    order = ">" if message.is_bigendian else "<"
    names, formats, offsets = [], [], []
    for each in message.fields:
        if each.datatype not in TYPES:
            raise ValueError(f"field {each.name!r}: expected a datatype from 1 to 8, got "
                             f"{each.datatype}")
        base = np.dtype(order + TYPES[each.datatype])
        if each.offset + base.itemsize * max(each.count, 1) > message.point_step:
            raise ValueError(f"field {each.name!r} reaches beyond a point of "
                             f"{message.point_step} bytes")
        if each.name in names:
            raise ValueError(f"field {each.name!r} is there twice")
        names.append(each.name)
        formats.append((base, (each.count,)) if each.count > 1 else base)
        offsets.append(each.offset)
    height, width = message.height, message.width
    data = np.ascontiguousarray(message.data, np.uint8)
    row_step = row_step_of(message, data.size)
    if height * width * message.point_step == 0:
        return {name: np.zeros(0, format) for name, format in zip(names, formats)}
    dtype = np.dtype({"names": names, "formats": formats, "offsets": offsets,
                      "itemsize": message.point_step})
    rows = np.ndarray((height, width), dtype, data.data,
                      strides=(row_step, message.point_step))
    return {name: native(rows[name].reshape((math.prod(rows.shape), *rows[name].shape[2:])))
            for name in names}


def row_step_of(message: Any, size: int) -> int:
    """The bytes from row to row of data of this size. Raises ValueError where they do not fit.

    Drivers that leave row_step 0, or put the bytes of the whole cloud there, are many: data of just
    the bytes of all points have rows without padding, whatever row_step says.
    """
    height, width, row_step = int(message.height), int(message.width), int(message.row_step)
    row = width * int(message.point_step)
    if size == height * row or height * width == 0:
        return row
    if size < height * row:
        raise ValueError(f"the cloud is cut short: {height} x {width} points of "
                         f"{message.point_step} bytes (height, width, point_step) take "
                         f"{height * row} bytes, and it has {size}")
    if height > 1 and (row_step < row or size < (height - 1) * row_step + row):
        raise ValueError(f"where its rows begin is not clear: {height} rows of {width} points take "
                         f"{height * row} bytes, the cloud has {size} bytes, and its row_step of "
                         f"{row_step} goes with neither")
    return row_step


def native(numbers: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The same in the machine's byte order."""
    return np.ascontiguousarray(numbers.astype(numbers.dtype.newbyteorder("=")))
