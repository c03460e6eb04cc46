"""Scans in NumPy's own files, and poses for them."""

import io
import zipfile

import numpy as np
import pytest

import groundgrid
from groundgrid.datasets import ArrayDataset

POINTS = np.arange(20, dtype=np.float32).reshape(5, 4)


def test_reads_columns_of_any_number(tmp_path):
    np.save(tmp_path / "scan.npy", POINTS.astype(np.float64)[:, :3])
    (scan,) = groundgrid.datasets.open(tmp_path / "scan.npy")
    np.testing.assert_array_equal(scan.points[:, :3], POINTS[:, :3])
    assert scan.name == "scan" and scan.points[:, 3].tolist() == [0] * 5
    assert scan.points.dtype == np.float32 and scan.pose is None
    assert scan.fields["x"].dtype == np.float64


def test_reads_records(tmp_path):
    records = np.zeros(5, [("ring", "u2"), ("x", "f8"), ("y", "f4"), ("z", "f4")])
    records["ring"], records["x"], records["z"] = range(5), POINTS[:, 0], -1.5
    np.save(tmp_path / "scan.npy", records)
    (scan,) = groundgrid.datasets.open(tmp_path / "scan.npy")
    np.testing.assert_array_equal(scan.points[:, 0], POINTS[:, 0])
    np.testing.assert_array_equal(scan.points[:, 2], -1.5)
    assert scan.fields["ring"].tolist() == [0, 1, 2, 3, 4]


def test_reads_named_arrays(tmp_path):
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    ring = np.arange(5, dtype=np.uint8)
    np.savez_compressed(tmp_path / "a.npz", points=POINTS, ring=ring, pose=pose, time_s=12.5,
                        labels=ring + 40, sensor=np.zeros(3))
    np.savez(tmp_path / "b.npz", x=POINTS[:, 0], y=POINTS[:, 1], z=POINTS[:, 2])
    first, second = groundgrid.datasets.open(tmp_path)
    np.testing.assert_array_equal(first.points, POINTS)
    np.testing.assert_array_equal(first.pose, pose)
    assert first.time_s == 12.5 and first.labels.tolist() == [40, 41, 42, 43, 44]
    assert list(first.fields) == ["x", "y", "z", "intensity", "ring"]
    np.testing.assert_array_equal(second.points[:, :3], POINTS[:, :3])


def test_a_folder_is_in_the_order_of_its_numbers(tmp_path):
    for number in (10, 9, 100):
        np.save(tmp_path / f"{number}.npy", POINTS + number)
    dataset = groundgrid.datasets.open(tmp_path)
    assert [scan.name for scan in dataset] == ["9", "10", "100"]
    assert dataset[-1].name == "100" and len(dataset) == 3
    with pytest.raises(IndexError):
        dataset[3]


def write_scans(folder, times):
    for number, time_s in enumerate(times):
        extra = {} if time_s is None else {"time_s": time_s}
        np.savez(folder / f"{number}.npz", points=POINTS, **extra)


def test_poses_of_kitti_are_line_by_line(tmp_path):
    write_scans(tmp_path, [5.0, 6.0])
    (tmp_path / "poses.txt").write_text("1 0 0 3 0 1 0 0 0 0 1 0\n" "0 -1 0 4 1 0 0 5 0 0 1 6\n")
    _, second = groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt")
    np.testing.assert_allclose(second.pose[:3, 3], [4, 5, 6])
    write_scans(tmp_path, [5.0, 6.0, 7.0])
    with pytest.raises(ValueError, match="pose of scan 2 in line 3, got .* after 2 poses"):
        list(groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt"))


def test_poses_of_tum_are_interpolated_where_scans_have_times(tmp_path):
    # A turn to the left by 90 degrees in two seconds; a quarter of the way is 22.5 degrees.
    root = np.sqrt(0.5)
    (tmp_path / "poses.txt").write_text(f"10 0 0 0 0 0 0 1\n12 4 0 0 0 0 {root} {root}\n")
    write_scans(tmp_path, [10.5, 12.05])
    first, second = groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt")
    angle = np.radians(22.5)
    np.testing.assert_allclose(first.pose[:2, 0], [np.cos(angle), np.sin(angle)], atol=1e-9)
    np.testing.assert_allclose(first.pose[:3, 3], [1, 0, 0])
    np.testing.assert_allclose(second.pose[:3, 3], [4, 0, 0])
    write_scans(tmp_path, [10.5, 12.2])
    with pytest.raises(ValueError, match="expected poses around 12.200 s, the time of scan 1"):
        list(groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt"))
    write_scans(tmp_path, [None, None])
    scans = list(groundgrid.datasets.open(tmp_path, poses=tmp_path / "poses.txt"))
    np.testing.assert_allclose(scans[1].pose[:3, :3], [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-9)


@pytest.mark.parametrize("turn", [0.0, 90.0, 180.0, 270.0])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_any_rotation_comes_back_from_its_quaternion(turn, axis):
    from groundgrid.datasets.transforms import matrix_of, quaternion_from

    quaternion = np.zeros(4)
    quaternion[axis], quaternion[3] = np.sin(np.radians(turn / 2)), np.cos(np.radians(turn / 2))
    matrix = matrix_of(np.zeros(3), quaternion)
    back = quaternion_from(matrix)
    np.testing.assert_allclose(matrix_of(np.zeros(3), back), matrix, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.npy", {"points": np.zeros((5, 2))}, "got float64 of shape"),
        ("a.npy", {"points": np.zeros((4, 5000))}, r"got shape \(4, 5000\); .* store points.T"),
        ("a.npz", {"points": np.zeros((3, 17))}, r"got shape \(3, 17\); .* store points.T"),
        ("a.npy", {"points": np.array(["x", "y"])}, "expected N x 3 or more numbers"),
        ("a.npz", {"x": np.zeros(3), "y": np.zeros(3)}, "got none named z"),
        ("a.npz", {"points": POINTS, "labels": np.zeros(4)}, "labels: expected 5 of them"),
        ("a.npz", {"points": POINTS, "labels": np.full(5, np.nan)}, "labels: expected finite"),
        ("a.npz", {"points": POINTS, "labels": np.full(5, "car")}, "labels: expected numbers, got"),
        ("a.npz", {"points": POINTS, "pose": np.eye(3)}, "pose: expected 4 x 4"),
        ("a.npz", {"points": POINTS, "pose": np.full((4, 4), np.nan)}, "pose: expected finite"),
        ("a.npz", {"points": POINTS, "pose": np.full((4, 4), "a")}, "pose: expected numbers, got"),
        ("a.npz", {"points": POINTS, "pose": 2 * np.eye(4)}, "pose: expected a rotation and a"),
        ("a.npz", {"points": POINTS, "pose": np.diag([1, 1, -1, 1])}, "pose: expected a rotation"),
        ("a.npz", {"points": POINTS, "pose": np.eye(4) + np.diag([2e9], 3)}, "pose: expected a pl"),
        ("a.npz", {"points": POINTS, "pose": np.diag([1, 1, 1, 2])}, "pose: expected 0 0 0 1"),
        ("a.npz", {"points": POINTS, "time_s": np.zeros(2)}, "time_s: expected a single number"),
        ("a.npz", {"points": POINTS, "time_s": np.nan}, "time_s: expected finite numbers, got NaN"),
        ("a.npz", {"points": POINTS, "time_s": "noon"}, "time_s: expected numbers, got"),
    ],
)
def test_arrays_that_are_no_scan_are_refused(tmp_path, name, content, words):
    if name.endswith("npy"):
        np.save(tmp_path / name, content["points"])
    else:
        np.savez(tmp_path / name, **content)
    with pytest.raises(ValueError, match=f"{name}: .*{words}"):
        ArrayDataset(tmp_path / name)[0]


@pytest.mark.parametrize("name", ["a.npy", "a.npz"])
@pytest.mark.parametrize("keep", [0, 5, 100])
def test_files_that_are_cut_short_are_refused(tmp_path, name, keep):
    np.save(tmp_path / "a.npy", POINTS)
    np.savez(tmp_path / "a.npz", points=POINTS)
    file = tmp_path / name
    file.write_bytes(file.read_bytes()[:keep])
    with pytest.raises(ValueError, match=name):
        ArrayDataset(file)[0]


def damaged_member(path, compression, change):
    """A .npz file with ring.npy as change() makes it."""
    buffer = io.BytesIO()
    np.save(buffer, np.arange(5, dtype=np.uint8))
    with zipfile.ZipFile(path, "w", compression) as archive:
        archive.writestr("ring.npy", change(buffer.getvalue()))


def test_damage_of_an_array_is_said_with_its_name(tmp_path):
    file = tmp_path / "a.npz"
    words = r"a.npz: ring: expected an array, got"
    # A header without its last brace, and one whose keys are not all text.
    for old, new in ((b"}", b" "), (b"'shape'", b"b'hape'")):
        damaged_member(file, zipfile.ZIP_STORED, lambda data: data.replace(old, new))
        with pytest.raises(ValueError, match=words):
            ArrayDataset(file)[0]
    damaged_member(file, zipfile.ZIP_STORED, lambda data: b"no array")
    with pytest.raises(ValueError, match=words):
        ArrayDataset(file)[0]


@pytest.mark.parametrize(
    ("place", "value"),
    [
        ("data", b"\xff"),
        # In the list at the end: a member that is encrypted, and one of an unknown compression.
        (8, b"\x01"),
        (10, b"\x63"),
    ],
)
def test_damage_of_an_archive_is_said_with_the_array(tmp_path, place, value):
    file = tmp_path / "a.npz"
    damaged_member(file, zipfile.ZIP_DEFLATED, bytes)
    content = file.read_bytes()
    # Behind the 30 bytes before a member's name.
    begin = 30 + len("ring.npy") if place == "data" else content.index(b"PK\x01\x02") + place
    if place == 8:
        content = content[:6] + value + content[7:]
    file.write_bytes(content[:begin] + value + content[begin + 1 :])
    with pytest.raises(ValueError, match=r"a.npz: ring: expected an array, got"):
        ArrayDataset(file)[0]


def test_a_header_of_one_array_that_is_no_python_is_refused(tmp_path):
    np.save(tmp_path / "a.npy", POINTS)
    content = (tmp_path / "a.npy").read_bytes()
    (tmp_path / "a.npy").write_bytes(content.replace(b"}", b" ", 1))
    with pytest.raises(ValueError, match="a.npy"):
        ArrayDataset(tmp_path / "a.npy")[0]


def test_a_header_that_promises_too_much_is_refused(tmp_path):
    np.save(tmp_path / "a.npy", POINTS)
    content = (tmp_path / "a.npy").read_bytes()
    (tmp_path / "a.npy").write_bytes(content.replace(b"(5, 4)", b"(9999999999, 4)", 1)[:176])
    with pytest.raises(ValueError, match="a.npy"):
        ArrayDataset(tmp_path / "a.npy")[0]


def test_pickled_objects_are_never_loaded(tmp_path):
    np.save(tmp_path / "a.npy", np.array([{"x": 1}], dtype=object), allow_pickle=True)
    with pytest.raises(ValueError, match="a.npy"):
        ArrayDataset(tmp_path / "a.npy")[0]


def test_what_is_not_there_is_said(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing.npy"):
        ArrayDataset(tmp_path / "nothing.npy")
    with pytest.raises(ValueError, match="expected files .npy or .npz, got none"):
        ArrayDataset(tmp_path)
    np.save(tmp_path / "a.npy", POINTS)
    with pytest.raises(FileNotFoundError, match="poses.txt"):
        ArrayDataset(tmp_path, poses=tmp_path / "poses.txt")
    with pytest.raises(TypeError):
        groundgrid.datasets.open(tmp_path, topic="/points")
