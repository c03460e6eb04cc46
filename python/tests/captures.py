"""Packet captures that tests write."""

import struct


def write_capture(path, payloads, microseconds_between):
    """Payloads as UDP packets on Ethernet, from 100 s on."""
    content = struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1)
    for number, payload in enumerate(payloads):
        udp = struct.pack(">HHHH", 2368, 2368, 8 + len(payload), 0) + payload
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0,
                         bytes([192, 168, 1, 201]), bytes([255] * 4)) + udp
        frame = bytes([255] * 6 + [0] * 6) + b"\x08\x00" + ip
        seconds, rest = divmod(number * microseconds_between, 1_000_000)
        content += struct.pack("<IIII", 100 + seconds, rest, len(frame), len(frame)) + frame
    path.write_bytes(content)
    return path
