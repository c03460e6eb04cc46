"""groundgrid-py rasterize, on tiles whose cells are worked out by hand."""

import struct

import numpy as np
import pytest
import rasterio
from las_files import geo_keys, write_las

from groundgrid.program.main import main

# Two ground points and a tree in the cell at (1.0 .. 1.5, 2.0 .. 2.5), one in that to the west.
PLACES = np.array([[1.1, 2.1, 10.0], [1.4, 2.4, 11.0], [1.2, 2.2, 30.0], [0.7, 2.3, 12.0],
                   [2.5, 1.0, 7.0]])
CLASSES = [2, 2, 5, 2, 9]


@pytest.fixture(autouse=True)
def _in_the_folder_of_outputs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def read(path):
    with rasterio.open(path) as raster:
        assert raster.units[0] == "m"
        return raster.read(1, masked=True), raster.read(2, masked=True), raster


@pytest.mark.parametrize("name", ["tile.las", "tile.laz"])
def test_ground_points_are_averaged_on_half_a_metre(tmp_path, name, capsys):
    tiles = tmp_path / "tiles"
    tiles.mkdir()
    write_las(tiles / name, PLACES, CLASSES, geo_keys(projected=32632))
    assert main(["rasterize", str(tiles / name)]) == 0
    heights, counts, raster = read(tmp_path / "tile.tif")
    assert heights.shape == (3, 5)
    expected = {(0, 1): 10.5, (0, 0): 12.0}
    for row in range(heights.shape[0]):
        for column in range(heights.shape[1]):
            if (row, column) in expected:
                assert heights[row, column] == expected[row, column]
            else:
                assert heights.mask[row, column] and counts[row, column] == 0
    assert counts[0, 1] == 2
    assert raster.bounds == (0.5, 1.0, 3.0, 2.5) and raster.res == (0.5, 0.5)
    assert raster.crs.to_epsg() == 32632
    assert "3 ground points" in capsys.readouterr().out
    assert sorted(each.name for each in tmp_path.iterdir()) == ["tile.tif", "tiles"]
    assert [each.name for each in tiles.iterdir()] == [name]


def test_feet_become_metres_of_height_and_stay_feet_of_the_system(tmp_path):
    foot = 1200 / 3937
    write_las(tmp_path / "tile.las", PLACES, CLASSES, geo_keys(projected=2903, vertical=9003))
    assert main(["rasterize", str(tmp_path / "tile.las"), "--cell-m", "0.3048006096012192"]) == 0
    heights, counts, raster = read(tmp_path / "tile.tif")
    # One foot a cell: from (0, 1) to (3, 3).
    assert raster.res == pytest.approx((1, 1)) and heights.shape == (2, 3)
    assert heights[0, 1] == pytest.approx(10.5 * foot) and heights[0, 0] == pytest.approx(12 * foot)
    assert raster.crs.to_epsg() == 2903


def test_other_classes_and_units_may_be_named(tmp_path):
    write_las(tmp_path / "tile.las", PLACES, CLASSES, geo_keys(projected=2903))
    tile, output = str(tmp_path / "tile.las"), tmp_path / "other.tif"
    flags = ["--class", "9", "--class", "5", "--height-unit", "m", "--output", str(output)]
    assert main(["rasterize", tile, *flags]) == 0
    assert read(output)[0].compressed().tolist() == [30.0, 7.0]


def test_withheld_points_do_not_count(tmp_path):
    write_las(tmp_path / "tile.las", PLACES, CLASSES, withheld=[0, 1, 0, 0, 0])
    assert main(["rasterize", str(tmp_path / "tile.las"), "--crs", "EPSG:25833"]) == 0
    heights, _, raster = read(tmp_path / "tile.tif")
    assert heights[0, 1] == 10 and raster.crs.to_epsg() == 25833


@pytest.mark.parametrize(
    ("flags", "words"),
    [
        (["--class", "6"], "expected points of class 6, got none"),
        (["--cell-m", "0"], "--cell-m: expected metres, more than 0, got 0"),
        (["--cell-m", "1e-6"], "cells, of which 400000000 would be possible"),
        (["--crs", "EPSG:0"], "--crs: "),
        (["--crs", "EPSG:4326"], "--crs: expected a system in metres or feet, got degrees"),
        (["--output", "{}/tile.las"], "tile.las: expected another file for --output than the tile"),
        (["--output", "{}/no/such/folder.tif"], "folder.tif: expected a place to write to"),
    ],
)
def test_what_cannot_be_is_said_and_leaves_nothing(tmp_path, capsys, flags, words):
    write_las(tmp_path / "tile.las", PLACES, CLASSES)
    flags = [flag.format(tmp_path) for flag in flags]
    assert main(["rasterize", str(tmp_path / "tile.las"), *flags]) == 1
    error = capsys.readouterr().err
    assert error.startswith("groundgrid-py: ") and words in error
    assert [each.name for each in tmp_path.iterdir()] == ["tile.las"]


@pytest.mark.parametrize("link", ["symlink_to", "hardlink_to"])
def test_the_tile_is_never_the_output_by_any_name(tmp_path, capsys, link):
    tile = write_las(tmp_path / "tile.las", PLACES, CLASSES)
    content = tile.read_bytes()
    getattr(tmp_path / "tile.tif", link)(tile)
    assert main(["rasterize", str(tile)]) == 1
    assert "tile.tif: expected another file for --output" in capsys.readouterr().err
    assert tile.read_bytes() == content
    assert sorted(each.name for each in tmp_path.iterdir()) == ["tile.las", "tile.tif"]


def test_a_system_is_checked_and_that_of_the_tile_wins(tmp_path, capsys):
    tile = write_las(tmp_path / "tile.las", PLACES, CLASSES, geo_keys(projected=32632))
    assert main(["rasterize", str(tile), "--crs", "nonsense"]) == 1
    assert "--crs: " in capsys.readouterr().err
    assert [each.name for each in tmp_path.iterdir()] == ["tile.las"]
    assert main(["rasterize", str(tile), "--crs", "EPSG:25833"]) == 0
    assert read(tmp_path / "tile.tif")[2].crs.to_epsg() == 32632


def test_the_unit_of_heights_is_asked_for(tmp_path, capsys):
    write_las(tmp_path / "tile.las", PLACES, CLASSES, geo_keys(projected=2903))
    assert main(["rasterize", str(tmp_path / "tile.las")]) == 1
    assert "expected the unit of the heights" in capsys.readouterr().err


@pytest.mark.parametrize("cell", [0.1, 0.2, 0.3, 0.5])
def test_points_at_the_edges_of_cells_are_within_the_bounds(tmp_path, cell):
    """Steps of a centimetre around places of a map, which are edges of cells again and again."""
    random = np.random.default_rng(1)
    for number in range(20):
        corner = random.integers([3000000, 40000000], [7000000, 60000000]) / 10
        places = np.column_stack([corner + random.integers(0, 400, (30, 2)) / 100, np.full(30, 5)])
        write_las(tmp_path / "tile.las", places, np.full(30, 2), scale=0.01)
        assert main(["rasterize", str(tmp_path / "tile.las"), "--cell-m", str(cell)]) == 0, number
        _, counts, raster = read(tmp_path / "tile.tif")
        assert counts.sum() == 30
        west, south, east, north = raster.bounds
        low, high = places[:, :2].min(axis=0), places[:, :2].max(axis=0)
        assert (low - [west, south] > -1e-6).all() and (low - [west, south] < cell + 1e-6).all()
        assert ([east, north] - high > -1e-6).all() and ([east, north] - high < cell + 1e-6).all()
        edges = np.array(raster.bounds) / cell
        np.testing.assert_allclose(edges, np.round(edges), rtol=0, atol=1e-6)


def test_a_tile_whose_edges_round_otherwise_than_its_points(tmp_path):
    places = np.array([[500000.0, 4000190.5, 1.0], [500001.0, 4000192.74, 2.0]])
    write_las(tmp_path / "tile.las", places, [2, 2], scale=0.01)
    assert main(["rasterize", str(tmp_path / "tile.las"), "--cell-m", "0.1"]) == 0
    heights = read(tmp_path / "tile.tif")[0]
    assert heights[0, -1] == 2 and heights[-1, 0] == 1 and heights.count() == 2


def with_bounds(path, **bounds):
    """The same file with other bounds in its header."""
    content = bytearray(path.read_bytes())
    for name, value in bounds.items():
        struct.pack_into("<d", content, {"east": 179, "west": 187, "north": 195}[name], value)
    path.write_bytes(content)


def test_bounds_may_be_rounded_by_less_than_a_step(tmp_path, capsys):
    tile = write_las(tmp_path / "tile.las", PLACES, CLASSES, scale=0.01)
    with_bounds(tile, west=0.704, east=2.496, north=2.396)
    assert main(["rasterize", str(tile), "--class", "2", "--class", "9"]) == 0
    heights, counts, raster = read(tmp_path / "tile.tif")
    assert raster.bounds == (0.5, 1.0, 2.5, 2.5) and counts.sum() == 4
    assert heights[0, :2].tolist() == [12.0, 10.5] and heights[2, 3] == 7.0
    with_bounds(tile, east=2.48)
    assert main(["rasterize", str(tile), "--class", "9"]) == 1
    assert "points outside of the bounds that the header has" in capsys.readouterr().err


def test_a_real_tile_in_feet(tmp_path, real_data):
    output = tmp_path / "crop.tif"
    tile = str(real_data / "airborne" / "4_6_crop.las")
    assert main(["rasterize", tile, "--output", str(output)]) == 0
    heights, counts, raster = read(output)
    assert counts.sum() == 9003
    foot = 1200 / 3937
    assert 7077.92 * foot <= heights.min() and heights.max() <= 7139.70 * foot
    assert raster.crs.to_epsg() == 2903 and raster.res[0] * foot == pytest.approx(0.5)
