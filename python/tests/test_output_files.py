"""What the extension module writes, and the blocks of a drive's terrain; files and folders on the
way to their names."""

import fcntl
import os
from pathlib import Path

import numpy as np
import pytest

import groundgrid
from groundgrid import _core
from groundgrid.output_files import hidden_file, hidden_folder, locked_folder

RECORDS = np.zeros(3, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("bins", "<u2", 2)])
FIELDS = [("x", "float32", 1), ("y", "float32", 1), ("z", "float32", 1), ("bins", "uint16", 2)]
BYTES = RECORDS.view(np.uint8).reshape(3, -1)
LABELS, HEIGHTS = np.array([40, 99, 0], np.uint32), np.array([0, 1.5, np.nan], np.float32)


def test_clouds_are_written_with_their_fields(tmp_path):
    records = RECORDS.copy()
    records["x"], records["bins"] = [1, 2, 3], [[1, 2], [3, 4], [5, 6]]
    _core.write_cloud(tmp_path / "a.pcd", "pcd", FIELDS, records.view(np.uint8).reshape(3, -1),
                      LABELS, HEIGHTS)
    fields = groundgrid.datasets.open(tmp_path / "a.pcd")[0].fields
    assert fields["x"].tolist() == [1, 2, 3] and fields["bins"].tolist() == [[1, 2], [3, 4], [5, 6]]
    assert fields["label"].tolist() == [40, 99, 0]
    np.testing.assert_array_equal(fields["height_above_ground"], HEIGHTS)


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"format": "las"}, ValueError, "format: expected 'pcd' or 'ply', got 'las'"),
        ({"fields": [("x", "float16", 1)]}, ValueError, "fields: expected numbers such as float32"),
        ({"fields": FIELDS[:3]}, ValueError, "records: expected the packed bytes"),
        ({"records": BYTES[:, ::-1]}, ValueError, "records: expected the packed bytes"),
        ({"records": BYTES[::2]}, ValueError, "records: expected the packed bytes"),
        ({"records": RECORDS}, ValueError, "records: expected the packed bytes"),
        ({"records": "bytes"}, TypeError, "records"),
        ({"labels": LABELS[1:]}, ValueError, None),
        ({"labels": HEIGHTS}, TypeError, "labels"),
        ({"heights": HEIGHTS[1:]}, ValueError, None),
        ({"path": 3}, TypeError, None),
        ({"path": "/no/such/folder/a.pcd"}, (ValueError, OSError), "a.pcd"),
    ],
)
def test_clouds_that_are_none_are_refused(tmp_path, change, error, words):
    arguments = {"path": tmp_path / "a.pcd", "format": "pcd", "fields": FIELDS, "records": BYTES,
                 "labels": LABELS, "heights": HEIGHTS}
    with pytest.raises(error, match=words):
        _core.write_cloud(**(arguments | change))
    assert not list(tmp_path.iterdir())


def test_labels_are_numbers_of_32_bits(tmp_path):
    _core.write_labels(tmp_path / "a.label", LABELS)
    assert np.fromfile(tmp_path / "a.label", "<u4").tolist() == [40, 99, 0]
    with pytest.raises(ValueError, match="labels"):
        _core.write_labels(tmp_path / "b.label", np.array([-1]))


def test_the_terrain_of_a_drive_comes_block_by_block(tmp_path, drive):
    terrain = _core.DriveTerrain(tmp_path / "terrain.tif")
    assert terrain.empty and terrain.shape == (0, 0) and terrain.resolution_m == 0
    with pytest.raises(IndexError, match="block: outside"):
        terrain.block(0, 0)
    grid = groundgrid.GroundGrid()
    for scan in drive:
        grid.process(scan.points, scan.pose)
        terrain.add(grid)
    rows, columns = terrain.shape
    assert not terrain.empty and 256 < max(rows, columns) < 400
    block = terrain.block(0, 0)
    assert block.shape == (5, 256, 256) and block.dtype == np.float32
    # Row 0 is in the north: each cell of the map is where the corner says.
    now, (west, north) = grid.terrain, terrain.corner_m
    row, column = np.argwhere(now.confidence == now.confidence.max())[0]
    place = (round((north - now.y_m[row]) / 0.33 - 0.5), round((now.x_m[column] - west) / 0.33 - 0.5))
    found = terrain.block(place[1] // 256, place[0] // 256)[0, place[0] % 256, place[1] % 256]
    assert found == pytest.approx(now.height[row, column], abs=0.05)
    for wrong in ((-1, 0), (0, -1), (2, 0), (0, 2), (2**40, 0)):
        with pytest.raises(IndexError):
            terrain.block(*wrong)
    with pytest.raises(ValueError, match="cell"):
        other = groundgrid.GroundGrid(resolution_m=0.5)
        other.process(drive[0].points)
        terrain.add(other)
    assert not list(tmp_path.iterdir())


def test_a_terrain_needs_a_folder(tmp_path):
    with pytest.raises((ValueError, OSError), match=r"terrain\.tif"):
        _core.DriveTerrain(tmp_path / "no" / "terrain.tif")


def test_a_file_appears_where_nothing_failed(tmp_path):
    with hidden_file(tmp_path / "a.txt") as hidden:
        hidden.write_text("whole")
        assert not (tmp_path / "a.txt").exists() and hidden.name.startswith(".groundgrid-")
    assert (tmp_path / "a.txt").read_text() == "whole"
    with pytest.raises(KeyError), hidden_file(tmp_path / "a.txt") as hidden:
        hidden.write_text("half")
        raise KeyError
    assert [each.name for each in tmp_path.iterdir()] == ["a.txt"]
    assert (tmp_path / "a.txt").read_text() == "whole"
    assert (tmp_path / "a.txt").stat().st_mode & 0o044


def test_two_files_of_one_name_do_not_mix(tmp_path):
    with hidden_file(tmp_path / "a.txt") as one, hidden_file(tmp_path / "a.txt") as other:
        one.write_text("one")
        other.write_text("the other")
    assert (tmp_path / "a.txt").read_text() == "one"
    assert [each.name for each in tmp_path.iterdir()] == ["a.txt"]


def test_a_file_that_took_the_hidden_name_is_not_committed(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"a\.txt: expected a place to write to, got another"):
        with hidden_file(tmp_path / "a.txt") as hidden:
            hidden.unlink()
            hidden.symlink_to("/etc/passwd")
    assert not list(tmp_path.iterdir())


def test_a_folder_appears_where_nothing_failed(tmp_path):
    with hidden_folder(tmp_path / "a") as hidden:
        (hidden / "below").mkdir(parents=True)
        (hidden / "below" / "b.txt").write_text("whole")
        assert not (tmp_path / "a").exists() and hidden.name == "a"
    assert [each.name for each in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a" / "below" / "b.txt").read_text() == "whole"
    with pytest.raises(KeyError), hidden_folder(tmp_path / "c") as hidden:
        hidden.mkdir()
        raise KeyError
    assert [each.name for each in tmp_path.iterdir()] == ["a"]


def test_bytes_are_on_the_disk_before_they_have_a_name(tmp_path, monkeypatch):
    synced = []

    def fsync(handle):
        synced.append(os.readlink(f"/proc/self/fd/{handle}"))
        if synced[-1].endswith("lost.txt"):
            raise OSError(5, "Input/output error")

    monkeypatch.setattr(os, "fsync", fsync)
    with hidden_folder(tmp_path / "a") as hidden:
        hidden.mkdir()
        (hidden / "b.txt").write_text("whole")
    assert sorted(Path(each).name for each in synced) == ["a", "b.txt"]
    with pytest.raises(OSError, match="Input/output"), hidden_folder(tmp_path / "c") as hidden:
        hidden.mkdir()
        (hidden / "lost.txt").write_text("lost")
    assert [each.name for each in tmp_path.iterdir()] == ["a"]


def test_a_folder_is_one_runs_and_leftovers_go(tmp_path):
    names = [f".groundgrid-{number:016x}.tmp" for number in range(3)]
    (tmp_path / names[0]).write_text("half")
    (tmp_path / names[1]).mkdir()
    (tmp_path / names[1] / "half.mcap").write_text("half")
    (tmp_path / ".groundgrid-another.tmp").write_text("kept")
    in_use = (tmp_path / names[2]).open("w")
    fcntl.flock(in_use, fcntl.LOCK_EX)
    with locked_folder(tmp_path):
        assert sorted(each.name for each in tmp_path.iterdir()) == [
            names[2], ".groundgrid-another.tmp", ".groundgrid.lock"]
        words = "expected a folder that no other run writes to, got one that is in use"
        with pytest.raises(ValueError, match=words), locked_folder(tmp_path):
            pass
    in_use.close()
    with locked_folder(tmp_path):
        pass
    assert [each.name for each in tmp_path.iterdir()] == [".groundgrid-another.tmp"]
