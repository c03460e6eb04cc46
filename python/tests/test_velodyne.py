"""Captures and recordings of a VLP-16, packet by packet as its manual has them."""

import struct

import numpy as np
import pytest
from captures import write_capture
from test_bags import STORE, cloud, header, store_of, write

import groundgrid
from groundgrid.datasets import BagDataset, VelodyneDataset

ELEVATIONS_DEG = [-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15]
MICROSECONDS_A_PACKET = 1327
PACKETS_A_TURN = 75  # of 12 blocks, each 0.4 degrees on


def packet(number):
    """Every laser sees something 5 m away but the first, which sees nothing."""
    blocks = b""
    for block in range(12):
        azimuth = (number * 480 + block * 40) % 36000
        returns = [(2500 if laser % 16 else 0, laser) for laser in range(32)]
        blocks += struct.pack("<HH", 0xEEFF, azimuth)
        blocks += b"".join(struct.pack("<HB", *each) for each in returns)
    return blocks + struct.pack("<IBB", number * MICROSECONDS_A_PACKET, 0x37, 0x22)


@pytest.fixture
def capture(tmp_path):
    packets = [packet(number) for number in range(2 * PACKETS_A_TURN + 10)]
    return write_capture(tmp_path / "drive.pcap", packets, MICROSECONDS_A_PACKET)


def test_turns_come_one_after_the_other(capture):
    dataset = groundgrid.datasets.open(capture)
    assert isinstance(dataset, VelodyneDataset)
    scans = list(dataset)
    assert [scan.name for scan in scans] == ["000000", "000001", "000002"]
    # Whole packets, and 15 of 16 lasers with a return, 24 times in a packet.
    assert all(len(scan.points) % (15 * 24) == 0 for scan in scans)
    assert sum(len(scan.points) for scan in scans) >= (2 * PACKETS_A_TURN - 1) * 15 * 24
    # The clock of the capture, which begins at 100 s.
    assert 100.09 < scans[0].time_s < 100.11
    assert scans[1].time_s - scans[0].time_s == pytest.approx(0.0995, abs=0.002)


def test_points_are_where_the_lasers_look(capture):
    scan = next(iter(groundgrid.datasets.open(capture)))
    distance = np.linalg.norm(scan.points[:, :3], axis=1)
    np.testing.assert_allclose(distance, 5.0, atol=0.02)
    by_ring = np.sort(ELEVATIONS_DEG)[scan.fields["ring"]]
    np.testing.assert_allclose(scan.points[:, 2], 5 * np.sin(np.radians(by_ring)), atol=0.02)
    # It begins ahead and turns clockwise.
    assert scan.points[0, 0] > 4.8 and scan.points[3000, 1] < -0.5
    assert set(scan.points[:, 3]) == set(range(1, 32)) - {16}
    assert scan.fields["time"].max() <= 0.0014
    assert np.ptp(scan.fields["time"]) == pytest.approx(0.1, abs=0.002)
    groundgrid.GroundGrid(sensor_height_m=1.0).process(scan.points)


def test_the_model_may_be_given(capture):
    scan = next(iter(VelodyneDataset(capture, model="VLP16")))
    np.testing.assert_allclose(np.linalg.norm(scan.points[:, :3], axis=1), 5.0, atol=0.02)
    with pytest.raises(ValueError, match="model: expected one of .*VLP16.*, got 'VLP15'"):
        VelodyneDataset(capture, model="VLP15")
    with pytest.raises(FileNotFoundError, match="angles.yml"):
        VelodyneDataset(capture, calibration="angles.yml")


def test_poses_are_taken_from_a_file(capture, tmp_path):
    (tmp_path / "poses.txt").write_text("100 0 0 0 0 0 0 1\n101 10 0 0 0 0 0 1\n")
    scans = list(VelodyneDataset(capture, poses=tmp_path / "poses.txt"))
    for scan in scans:
        assert scan.pose[0, 3] == pytest.approx(10 * (scan.time_s - 100))


@pytest.mark.parametrize("content", [b"", b"no capture, " * 9, None])
def test_other_files_are_refused(capture, tmp_path, content):
    # None: the head of a capture, and a record that is cut short.
    other = tmp_path / "other.pcap"
    other.write_bytes(capture.read_bytes()[:400] if content is None else content)
    with pytest.raises(ValueError, match="other.pcap"):
        list(VelodyneDataset(other))
    with pytest.raises(FileNotFoundError, match="nothing.pcap"):
        VelodyneDataset(tmp_path / "nothing.pcap")


def velodyne(store, first, time_s):
    """A turn of packets, the last of them at the time of the header."""
    scan, kind = (store.types[f"velodyne_msgs/msg/{name}"]
                  for name in ("VelodyneScan", "VelodynePacket"))
    step = MICROSECONDS_A_PACKET * 1e-6
    packets = [kind(header(store, time_s + (number + 1 - PACKETS_A_TURN) * step, "").stamp,
                    np.frombuffer(packet(first + number), np.uint8))
               for number in range(PACKETS_A_TURN)]
    return scan(header(store, time_s, "velodyne"), packets)


@pytest.mark.parametrize("storage", ["ros1", "MCAP"])
def test_velodyne_packets_are_clouds_with_times(tmp_path, storage):
    store = store_of(storage)
    messages = [("/velodyne_packets", velodyne(store, 0, 100.1), 0),
                ("/velodyne_packets", velodyne(store, PACKETS_A_TURN, 100.2), 1)]
    path = write(tmp_path / "drive", messages, storage)
    first, second = groundgrid.datasets.open(path)
    for scan in (first, second):
        assert len(scan.points) == PACKETS_A_TURN * 15 * 24
        np.testing.assert_allclose(np.linalg.norm(scan.points[:, :3], axis=1), 5.0, atol=0.02)
        assert scan.fields["time"].min() == pytest.approx(-0.1, abs=0.003)
        assert abs(scan.fields["time"].max()) < 0.002
    assert first.time_s == pytest.approx(100.1) and set(second.fields["ring"]) <= set(range(16))
    with pytest.raises(ValueError, match="model: expected one of"):
        list(groundgrid.datasets.open(path, model="VLP15"))


def test_clouds_go_before_the_packets_that_they_are_made_of(tmp_path):
    messages = [("/packets", velodyne(STORE, 0, 1.0), 1), ("/points", cloud(STORE, "plain", 0), 1)]
    path = write(tmp_path / "drive", messages, "MCAP")
    assert BagDataset(path).topic == "/points"
    (scan,) = BagDataset(path, topic="/packets")
    assert len(scan.points) == PACKETS_A_TURN * 15 * 24
