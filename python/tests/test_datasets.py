import subprocess
import sys

import numpy as np
import pytest

import groundgrid
from groundgrid.datasets import FileDataset
from groundgrid.datasets.extras import require

POINTS = np.arange(20, dtype=np.float32).reshape(5, 4)


def write_kitti(folder, names=("000000", "000001")):
    (folder / "velodyne").mkdir(parents=True)
    (folder / "labels").mkdir()
    for i, name in enumerate(names):
        (POINTS + i).tofile(folder / "velodyne" / f"{name}.bin")
        (np.arange(5, dtype=np.uint32) + i).tofile(folder / "labels" / f"{name}.label")
    # The camera's axes are the LiDAR's, 1 m ahead of it.
    (folder / "calib.txt").write_text("Tr: 1 0 0 -1 0 1 0 0 0 0 1 0\n")
    (folder / "poses.txt").write_text(
        "".join(f"1 0 0 {2 * i} 0 1 0 0 0 0 1 0\n" for i in range(len(names)))
    )


def test_reads_semantic_kitti(tmp_path):
    write_kitti(tmp_path / "sequences" / "03")
    dataset = groundgrid.datasets.open(tmp_path)
    assert (len(dataset), dataset.name) == (2, "03")
    for i, scan in enumerate(dataset):
        assert scan.name == f"00000{i}"
        np.testing.assert_array_equal(scan.points, POINTS + i)
        np.testing.assert_array_equal(scan.labels, np.arange(5) + i)
        np.testing.assert_allclose(scan.pose[:3, 3], [2 * i, 0, 0])
        np.testing.assert_array_equal(scan.fields["z"], POINTS[:, 2] + i)


def test_one_of_several_sequences_is_to_be_named(tmp_path):
    write_kitti(tmp_path / "sequences" / "00")
    write_kitti(tmp_path / "sequences" / "01", names=("000007",))
    assert groundgrid.datasets.sequence_names(tmp_path) == ["00", "01"]
    with pytest.raises(ValueError, match="choose one by sequence=: 00, 01"):
        groundgrid.datasets.open(tmp_path)
    with pytest.raises(ValueError):  # poses.txt has no line 8
        groundgrid.datasets.open(tmp_path, sequence="01")
    assert len(groundgrid.datasets.open(tmp_path, sequence="0")) == 2


def test_reads_plain_folders_with_poses_of_their_own(tmp_path):
    for i in range(3):
        (POINTS + i).tofile(tmp_path / f"{i}.bin")
    assert next(iter(FileDataset(tmp_path))).pose is None
    (tmp_path / "poses.txt").write_text(
        "".join(f"0.{i} {i} 0 0 0 0 0.7071068 0.7071068\n" for i in range(3))
    )
    dataset = FileDataset(tmp_path, poses=tmp_path / "poses.txt", format="kitti")
    expected = [[0, -1, 0, 2], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    np.testing.assert_allclose(dataset[2].pose, expected, atol=1e-6)
    np.testing.assert_array_equal(dataset[-1].points, POINTS + 2)
    with pytest.raises(IndexError):
        dataset[3]


def test_reads_every_field_of_pcd_and_ply(tmp_path):
    header = (
        "VERSION .7\nFIELDS ring x y z t\nSIZE 1 8 8 8 4\nTYPE U F F F U\nCOUNT 1 1 1 1 2\n"
        "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
    )
    (tmp_path / "scan.pcd").write_text(header + "3 1 2 -1.5 7 8\n4 5 6 nan 9 10\n")
    scan = groundgrid.datasets.open(tmp_path / "scan.pcd")[0]
    np.testing.assert_array_equal(scan.points, [[1, 2, -1.5, 0], [5, 6, np.nan, 0]])
    assert scan.fields["ring"].tolist() == [3, 4] and scan.fields["ring"].dtype == np.uint8
    assert scan.fields["t"].tolist() == [[7, 8], [9, 10]]
    (tmp_path / "scan.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar intensity\nend_header\n1 2 3 200\n"
    )
    scan = groundgrid.datasets.open(tmp_path / "scan.ply")[0]
    np.testing.assert_array_equal(scan.points, [[1, 2, 3, 200]])
    assert scan.labels is None and scan.time_s is None


def test_files_are_those_of_the_scans(tmp_path):
    for name in ("000001.bin", "000000.bin"):
        np.zeros((5, 4), np.float32).tofile(tmp_path / name)
    assert FileDataset(tmp_path).files == [tmp_path / "000000.bin", tmp_path / "000001.bin"]


def road(points, random):
    """x y z intensity ring of a level road, in an order of no sensor."""
    place = random.uniform(-30, 30, (points, 2))
    rest = np.full(points, -1.73), random.uniform(0, 1, points), np.arange(points) % 16
    return np.column_stack([place, *rest]).astype(np.float32)


def test_layouts_are_told_by_their_numbers_which_is_said(tmp_path):
    points = road(1600, np.random.default_rng(0))
    points.tofile(tmp_path / "0.bin")
    with pytest.warns(UserWarning, match="read as nuscenes"):
        scan = FileDataset(tmp_path)[0]
    np.testing.assert_array_equal(scan.points, points[:, :4])
    np.testing.assert_array_equal(scan.fields["ring"], points[:, 4])
    assert len(FileDataset(tmp_path, format="kitti")[0].points) == 2000


def test_scans_that_the_poses_leave_out_have_none(tmp_path):
    scans = tmp_path / "data_3d_raw" / "drive" / "velodyne_points" / "data"
    scans.mkdir(parents=True)
    for number in range(3):
        POINTS.tofile(scans / f"{number:010}.bin")
    poses = tmp_path / "data_poses" / "drive" / "poses.txt"
    poses.parent.mkdir(parents=True)
    poses.write_text("0 1 0 0 0 0 1 0 0 0 0 1 0\n2 1 0 0 7 0 1 0 0 0 0 1 0\n")
    for dataset in (groundgrid.datasets.open(tmp_path), FileDataset(scans, poses=poses)):
        first, second, third = dataset
        assert first.pose is not None and second.pose is None
        assert third.pose[0, 3] == 7.0
    np.save(tmp_path / "0.npy", POINTS)
    with pytest.raises(ValueError, match="poses for scans by their numbers"):
        groundgrid.datasets.open(tmp_path / "0.npy", poses=poses)


def test_a_calibration_wants_poses(tmp_path):
    np.zeros((5, 4), np.float32).tofile(tmp_path / "000000.bin")
    with pytest.raises(ValueError, match="calibration: expected together with poses"):
        FileDataset(tmp_path, calibration=tmp_path / "calib.txt")


def test_bad_files_are_refused_with_the_place(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing"):
        groundgrid.datasets.open(tmp_path / "nothing")
    (tmp_path / "short.bin").write_bytes(b"0123456789")
    with pytest.raises(ValueError, match="short.bin"):
        groundgrid.datasets.open(tmp_path / "short.bin")[0]
    with pytest.raises(ValueError, match="expected kitti, nuscenes, pcd, .* got 'las'"):
        FileDataset(tmp_path / "short.bin", format="las")
    with pytest.raises(TypeError):
        FileDataset(3.5)


@pytest.mark.parametrize("sequence", ["00", "09"])
def test_reads_real_semantic_kitti(real_data, sequence):
    dataset = groundgrid.datasets.open(real_data / "semantickitti", sequence=sequence)
    assert len(dataset) == 10
    scan = dataset[9]
    assert len(scan.points) == len(scan.labels) > 100000
    assert 1 < np.linalg.norm(scan.pose[:3, 3]) < 15


def test_reads_real_nuscenes_and_pcd(real_data):
    nuscenes = next((real_data / "sensors").glob("*.pcd.bin"))
    scan = groundgrid.datasets.open(nuscenes)[0]
    assert set(scan.fields) >= {"x", "y", "z", "intensity", "ring"}
    assert scan.fields["ring"].max() == 31
    names = {scan.name: len(scan.points) for scan in groundgrid.datasets.open(real_data / "pcd")}
    assert names["patchwork_128beam_binary_compressed"] == 128 * 1875


def test_a_missing_extra_names_the_line_that_installs_it(tmp_path):
    (tmp_path / "drive.bag").write_bytes(b"")
    program = (
        "import sys; sys.modules['rosbags'] = None\n"
        "import groundgrid\n"
        f"groundgrid.datasets.open({str(tmp_path / 'drive.bag')!r})\n"
    )
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert "pip install 'groundgrid[bags]'\n" in result.stderr


def test_what_a_package_lacks_is_said(tmp_path, monkeypatch):
    (tmp_path / "broken_package.py").write_text("raise ImportError('libGL.so.1: not there')\n")
    monkeypatch.syspath_prepend(tmp_path)
    words = "reading needs broken_package, which cannot be loaded: libGL.so.1: not there"
    with pytest.raises(ImportError, match=words):
        require("broken_package", "bags", "reading")


def test_what_must_be_installed_alone_is_said_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "ouster.sdk", None)
    with pytest.raises(ImportError, match=r"'groundgrid\[ouster\]', in a virtual environment of"):
        require("ouster.sdk", "ouster", "reading an Ouster capture")
