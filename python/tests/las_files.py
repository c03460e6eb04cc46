"""LAS and LAZ files that tests write."""

import laspy
import numpy as np
from laspy.vlrs.known import GeoKeyDirectoryVlr, GeoKeyEntryStruct, WktCoordinateSystemVlr


def geo_keys(**keys):
    """A record of GeoTIFF keys: of the model, the systems, the length and the vertical unit."""
    numbers = {"model": 1024, "geographic": 2048, "projected": 3072, "unit": 3076, "vertical": 4099}
    vlr = GeoKeyDirectoryVlr()
    for name, value in keys.items():
        entry = GeoKeyEntryStruct()
        entry.id, entry.tiff_tag_location = numbers[name], 0
        entry.count, entry.value_offset = 1, value
        vlr.geo_keys.append(entry)
    vlr.geo_keys_header.number_of_keys = len(vlr.geo_keys)
    return vlr


def wkt(text):
    return WktCoordinateSystemVlr(text)


def write_las(path, places, classes=None, vlr=None, scale=0.001, **fields):
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.offsets = np.floor(np.min(places, axis=0)) if len(places) else np.zeros(3)
    header.scales = np.full(3, scale)
    if vlr is not None:
        header.vlrs.append(vlr)
        header.global_encoding.wkt = isinstance(vlr, WktCoordinateSystemVlr)
    las = laspy.LasData(header)
    las.x, las.y, las.z = np.asarray(places, float).T.reshape(3, -1)
    if classes is not None:
        las.classification = np.asarray(classes, np.uint8)
    for name, values in fields.items():
        las[name] = values
    las.write(path)
    return path
