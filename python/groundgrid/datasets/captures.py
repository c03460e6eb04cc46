"""Packet captures: which LiDAR they are of."""

from __future__ import annotations

import struct
from pathlib import Path

ENDINGS = frozenset({".pcap", ".pcapng"})
# Of microseconds and nanoseconds in either byte order.
BYTE_ORDERS = {b"\xd4\xc3\xb2\xa1": "<", b"\x4d\x3c\xb2\xa1": "<",
               b"\xa1\xb2\xc3\xd4": ">", b"\xa1\xb2\x3c\x4d": ">"}
VELODYNE_BYTES = 1206
# Of the headers around it: Ethernet or its replacement, tags, IP, UDP.
HEADER_BYTES = range(28, 68)
LOOK_AT = 200


def is_velodyne(path: Path) -> bool:
    """Whether one of the first packets has the length that Velodyne's have."""
    with path.open("rb") as file:
        order = BYTE_ORDERS.get(file.read(24)[:4])
        if order is None:
            return False
        for _ in range(LOOK_AT):
            head = file.read(16)
            if len(head) < 16:
                break
            captured, length = struct.unpack(order + "8xII", head)
            if length - VELODYNE_BYTES in HEADER_BYTES:
                return True
            file.seek(captured, 1)
    return False
