"""Captures of Ouster's LiDARs: real ones, and one that the SDK writes."""

import numpy as np
import pytest

import groundgrid
from groundgrid.datasets import OusterDataset

core = pytest.importorskip(
    "ouster.sdk.core", reason="ouster-sdk goes with no other extra; see build/python-ouster"
)

RANGE_MM = 8000
FRAME_NS = 100_000_000


def frame(info, number):
    lidar = core.LidarFrame(info)
    lidar.frame_id = number
    lidar.status[:] = 1
    lidar.measurement_id[:] = np.arange(lidar.w)
    lidar.timestamp[:] = (number + 10) * FRAME_NS + np.arange(lidar.w) * 1000
    lidar.packet_timestamp[:] = lidar.timestamp[:: lidar.w // len(lidar.packet_timestamp)]
    lidar.field("RANGE")[:] = RANGE_MM
    lidar.field("RANGE")[0] = 0
    lidar.field("SIGNAL")[:] = 50 + number
    return lidar


@pytest.fixture
def capture(tmp_path):
    from ouster.sdk import pcap

    info = core.SensorInfo.from_default(core.LidarMode._512x10)
    info.config.udp_port_lidar = 7502
    form = core.PacketFormat(info)
    packets = [packet for number in range(2)
               for packet in core.frame_to_packets(frame(info, number), form, 0, 0)]
    for packet in packets:
        packet.host_timestamp = packet.host_timestamp or FRAME_NS
    pcap.record(packets, str(tmp_path / "drive.pcap"))
    (tmp_path / "drive.json").write_text(info.to_json_string())
    return tmp_path / "drive.pcap"


def test_reads_what_the_sdk_writes(capture):
    dataset = groundgrid.datasets.open(capture)
    assert isinstance(dataset, OusterDataset) and len(dataset) == 2
    for number, scan in enumerate(dataset):
        assert scan.name == f"00000{number}"
        assert scan.time_s == pytest.approx(1 + number / 10)
        points = scan.points.reshape(64, 512, 4)
        assert not points[0, :, :3].any()  # without a return
        distance = np.linalg.norm(points[1:, :, :3], axis=2)
        np.testing.assert_allclose(distance, RANGE_MM / 1000, atol=0.05)
        assert (points[:, :, 3] == 50 + number).all()
        assert (np.diff(points[1:, 0, 2]) < 0).all()  # rings from the top
        assert scan.fields["ring"].reshape(64, 512)[7].tolist() == [7] * 512
        assert scan.fields["t"][:3].tolist() == [0, 1000, 2000]


def test_reads_a_real_capture_with_its_poses(real_data):
    sensors = real_data / "sensors"
    dataset = groundgrid.datasets.open(
        sensors / "OS-1-128_v2.3.0_1024x10_lb_n3.pcap",
        metadata=sensors / "OS-1-128_v2.3.0_1024x10.json",
        poses=sensors / "OS-1-128_v2.3.0_1024x10_lb_n3_poses_kitti.txt",
    )
    assert len(dataset) == 3
    grid = groundgrid.GroundGrid()
    for scan in dataset:
        assert scan.points.shape == (128 * 1024, 4)
        result = grid.process(scan.points, scan.pose)
        assert result.ground > 40000 and result.obstacle > 40000
        assert 1.7 < result.sensor_height_m < 2.1
    np.testing.assert_allclose(scan.pose[:3, 3], [0.4978, 0.0060, -0.0006], atol=1e-3)
    assert scan.time_s == pytest.approx(991.787, abs=1e-3)


def test_reads_an_older_capture_with_metadata_of_its_own_name(real_data):
    sensors = real_data / "sensors"
    (scan,) = OusterDataset(sensors / "OS-1-64_1024x10_fw20.pcap",
                            metadata=sensors / "OS-1-64_sensor_config_reduced.json")
    assert scan.points.shape == (64 * 1024, 4)
    assert np.linalg.norm(scan.points[:, :3], axis=1).max() == pytest.approx(78.859, abs=0.1)


def test_other_files_are_refused(capture, tmp_path):
    (tmp_path / "other.pcap").write_bytes(b"no capture, " * 9)
    with pytest.raises(ValueError, match="other.pcap: expected an Ouster capture"):
        OusterDataset(tmp_path / "other.pcap")
    with pytest.raises(ValueError, match="other.pcap: expected an Ouster capture"):
        OusterDataset(tmp_path / "other.pcap", metadata=tmp_path / "drive.json")
    with pytest.raises(FileNotFoundError, match="nothing.pcap"):
        OusterDataset(tmp_path / "nothing.pcap")
    with pytest.raises(FileNotFoundError, match="nothing.json"):
        OusterDataset(capture, metadata=tmp_path / "nothing.json")
    with pytest.raises(ValueError, match="expected a sensor from 0 to 0, got 1"):
        OusterDataset(capture, sensor=1)
