"""LAS and LAZ, with coordinates of a sensor and of a map, in metres and feet."""

import io
import os
import struct
import subprocess
import sys

import laspy
import lazrs
import numpy as np
import pytest
from las_files import geo_keys, write_las, wkt

import groundgrid
from groundgrid.datasets.las_units import las_errors

NEAR = np.array([[1.5, -2.25, -1.625], [30.0, 4.0, 0.5]])
FAR = np.array([[500000.25, 5400000.5, 300.125], [500100.25, 5400050.5, 310.125]])
FOOT, US_FOOT = 0.3048, 1200 / 3937
COMPOUND = (
    'COMPD_CS["a",PROJCS["NAD83 / Utah North (ft)",GEOGCS["NAD83",DATUM["NAD83",'
    'SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],'
    'UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],'
    'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",-111],'
    'PARAMETER["scale_factor",1],PARAMETER["false_easting",0],PARAMETER["false_northing",0],'
    'UNIT["foot",0.3048]],VERT_CS["height",VERT_DATUM["any [m]",2005],UNIT["metre",1]]]'
)


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_coordinates_of_a_sensor_stay(tmp_path, name):
    write_las(tmp_path / name, NEAR, [2, 5], intensity=[7, 8])
    (scan,) = groundgrid.datasets.open(tmp_path / name)
    np.testing.assert_array_equal(scan.points[:, :3], NEAR.astype(np.float32))
    assert scan.points[:, 3].tolist() == [7, 8] and scan.pose is None and scan.name == "scan"
    assert scan.fields["classification"].tolist() == [2, 5]
    np.testing.assert_array_equal(scan.fields["x"], NEAR[:, 0])


def test_coordinates_of_a_map_are_told_from_the_middle_and_the_pose_leads_back(tmp_path):
    write_las(tmp_path / "scan.laz", FAR)
    (scan,) = groundgrid.datasets.open(tmp_path)
    assert np.abs(scan.points).max() < 51
    np.testing.assert_array_equal(scan.pose[:3, 3], np.round(FAR.mean(axis=0)))
    np.testing.assert_allclose(scan.points[:, :3] + scan.pose[:3, 3], FAR, atol=1e-5)


@pytest.mark.parametrize(
    ("vlr", "across", "up"),
    [
        (None, 1.0, 1.0),
        (geo_keys(projected=2903, unit=9003, vertical=9003), US_FOOT, US_FOOT),
        (geo_keys(projected=2903), US_FOOT, US_FOOT),
        (geo_keys(projected=32767, unit=9002, vertical=9001), FOOT, 1.0),
        (geo_keys(projected=32632, vertical=9002), 1.0, FOOT),
        (geo_keys(model=1, geographic=4269, projected=32767, unit=9002), FOOT, FOOT),
        (geo_keys(model=1, geographic=4326, unit=9001), 1.0, 1.0),
        (geo_keys(geographic=4326, projected=32632), 1.0, 1.0),
        (wkt(COMPOUND), FOOT, 1.0),
    ],
)
def test_feet_become_metres(tmp_path, vlr, across, up):
    write_las(tmp_path / "scan.las", NEAR, vlr=vlr)
    (scan,) = groundgrid.datasets.open(tmp_path / "scan.las")
    expected = NEAR * [across, across, up]
    np.testing.assert_allclose(scan.points[:, :3], expected, rtol=1e-6)


def test_poses_are_taken_from_a_file(tmp_path):
    write_las(tmp_path / "0.las", NEAR)
    write_las(tmp_path / "1.las", NEAR)
    (tmp_path / "poses.txt").write_text("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 2 0 1 0 0 0 0 1 0\n")
    dataset = groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt")
    assert [scan.pose[0, 3] for scan in dataset] == [0, 2]


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
@pytest.mark.parametrize("keep", [0, 100, -30])
def test_files_that_are_cut_short_are_refused(tmp_path, name, keep):
    file = write_las(tmp_path / name, np.random.default_rng(1).uniform(0, 9, (500, 3)))
    file.write_bytes(file.read_bytes()[:keep])
    with pytest.raises(ValueError, match=f"{name}: expected a LAS or LAZ file"):
        groundgrid.datasets.open(file)[0]


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
@pytest.mark.parametrize("place", [100, 243])
@pytest.mark.parametrize("count", [100, 100_000])
def test_more_records_than_the_file_can_hold_are_refused(tmp_path, name, place, count):
    file = write_las(tmp_path / name, NEAR)
    content = bytearray(file.read_bytes())
    struct.pack_into("<I", content, place, count)
    file.write_bytes(content)
    # With billions laspy would not come back.
    words = f"{name}: expected a LAS or LAZ file, got: {count} records of"
    with pytest.raises(ValueError, match=words):
        groundgrid.datasets.open(file)[0]


CHILD = """
import resource, sys
from groundgrid.datasets import LasDataset
import laspy, lazrs, rasterio.crs
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 2**31,) * 2)
try:
    LasDataset(sys.argv[1])[0]
except ValueError as error:
    print(error)
"""


def promising(content, what):
    """A LAZ file's content that asks for gigabytes at one place."""
    points, = struct.unpack_from("<I", content, 96)
    table, = struct.unpack_from("<q", content, points)
    # Behind the head of the record.
    record = content.index(b"laszip encoded") + 52
    if what == "bytes of a chunk":
        written = io.BytesIO()
        vlr = lazrs.LazVlr(bytes(content[record : record + 70]))
        lazrs.write_chunk_table(written, [(50000, 2**31 - 256)], vlr)
        return content[:table] + written.getvalue()
    place, kind = {
        "points": (247, "<Q"), "size of a chunk": (record + 12, "<I"), "chunks": (table + 4, "<I"),
        "bytes of a layer": (points + 8 + 30 + 4, "<I"),
    }[what]
    struct.pack_into(kind, content, place, 0xFFFFFF00)
    return content


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ("points", "4294967040 points in a file of"),
        ("size of a chunk", "4294967040 points in a file of"),
        ("chunks", "4294967040 chunks in"),
        ("bytes of a chunk", "chunks of more than the"),
        ("bytes of a layer", "a chunk of "),
    ],
)
def test_laz_files_that_promise_too_much_are_refused_at_once(tmp_path, what, words):
    file = write_las(tmp_path / "scan.laz", np.random.default_rng(1).uniform(0, 9, (500, 3)))
    file.write_bytes(promising(bytearray(file.read_bytes()), what))
    # lazrs ends the program where memory is short.
    ended = subprocess.run([sys.executable, "-c", CHILD, str(file)],
                           capture_output=True, text=True,
                           env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)})
    assert ended.returncode == 0, ended.stderr
    assert f"scan.laz: expected a LAS or LAZ file, got: {words}" in ended.stdout


def test_laz_files_of_any_format_and_size_pass_the_checks(tmp_path):
    for kind, count in [(0, 120_000), (3, 1), (6, 120_000), (7, 0), (8, 9), (10, 9)]:
        header = laspy.LasHeader(version="1.4", point_format=kind)
        header.add_extra_dim(laspy.ExtraBytesParams("range", "float32"))
        las = laspy.LasData(header)
        las.x = las.y = las.z = np.arange(count) * 0.01
        las.write(tmp_path / f"{kind}.laz")
        assert len(groundgrid.datasets.open(tmp_path / f"{kind}.laz")[0].points) == count


class PanicException(BaseException):
    """As pyo3 has it, which cannot be imported."""


def test_panics_of_lazrs_are_errors_of_the_file(tmp_path):
    with pytest.raises(ValueError, match="a.laz: .* one that is damaged: divisor of zero"):
        with las_errors(tmp_path / "a.laz"):
            raise PanicException("divisor of zero")
    with pytest.raises(KeyboardInterrupt), las_errors(tmp_path / "a.laz"):
        raise KeyboardInterrupt


DEGREES = (
    'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
    'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]'
)


@pytest.mark.parametrize(
    "vlr",
    [wkt(DEGREES), geo_keys(model=2, geographic=4326), geo_keys(model=2), geo_keys(geographic=4326),
     geo_keys(model=32767, geographic=4326, vertical=9001)],
)
def test_degrees_are_refused(tmp_path, vlr):
    write_las(tmp_path / "scan.las", NEAR, vlr=vlr)
    words = "scan.las: .*expected coordinates in metres or feet, got degrees"
    with pytest.raises(ValueError, match=words):
        groundgrid.datasets.open(tmp_path / "scan.las")[0]


def test_what_is_not_there_is_said(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing.laz"):
        groundgrid.datasets.open(tmp_path / "nothing.laz")


def test_an_empty_file_is_a_scan_of_no_points(tmp_path):
    write_las(tmp_path / "scan.las", np.zeros((0, 3)))
    assert groundgrid.datasets.open(tmp_path / "scan.las")[0].points.shape == (0, 4)


def test_reads_real_tiles(real_data):
    dataset = groundgrid.datasets.open(real_data / "airborne")
    scans = {scan.name: scan for scan in dataset}
    # In feet: 1178 by 563 of them, and heights from 406 to 521.
    autzen = scans["autzen_trim"]
    assert len(autzen.points) == 110000
    np.testing.assert_allclose(np.ptp(autzen.points, axis=0)[:3],
                               np.array([1177.46, 562.70, 114.25]) * FOOT, atol=1e-3)
    assert np.bincount(autzen.fields["classification"]).tolist() == [0, 83893, 26107]
    # In metres, compressed, without a vertical unit.
    hills = scans["Topography"]
    np.testing.assert_allclose(np.ptp(hills.points[:, 2]), 829.75825 - 788.99325, atol=1e-3)
