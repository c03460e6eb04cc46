"""groundgrid-py compare, with peers made up for it: PyPI's own are not needed."""

import json
import os

import numpy as np
import pytest

import groundgrid
from groundgrid import Label, peers
from groundgrid.program import compare
from groundgrid.program.main import main


class BelowOneMetre:
    def __init__(self, sensor_height_m):
        assert 1.0 < sensor_height_m < 2.1

    def segment(self, points):
        os.write(1, b"noise of a peer")
        assert np.isfinite(points).all() and points.flags.c_contiguous
        assert points[:, :3].any(axis=1).all()
        return peers.Answer(points[:, 2] < -1)


def not_installed(_):
    peers.package("no_such_package", "Gone")


@pytest.fixture
def folder(drive, tmp_path, monkeypatch):
    monkeypatch.setattr(compare, "PEERS", {"below": BelowOneMetre, "gone": not_installed})
    for number, scan in enumerate(drive):
        np.savez(tmp_path / f"{number}.npz", points=scan.points, pose=scan.pose, labels=scan.labels)
    return tmp_path


def test_each_method_is_scored_with_the_paper_s_figures(folder, drive, capfd):
    assert main(["compare", str(folder), "--json"]) == 0
    figures = json.loads(capfd.readouterr().out)
    assert list(figures) == ["groundgrid", "groundgrid paper", "below"]
    metrics = groundgrid.evaluation.SegmentationMetrics()
    ground, agreed, answered = 0, 0, 0
    grid = groundgrid.GroundGrid()
    for scan in groundgrid.datasets.open(folder):
        labels = np.where(scan.points[:, 2] < -1, 40, 99)
        places = scan.points[:, :3]
        labels[~np.isfinite(places).all(axis=1) | ~places.any(axis=1)] = 0
        metrics.add_scan(scan.points, scan.labels, labels)
        ours = grid.process(scan.points, scan.pose).labels
        both = (labels != 0) & (ours != Label.UNKNOWN)
        answered += both.sum()
        ground += (labels[both] == 40).sum()
        agreed += ((labels[both] == 40) == (ours[both] == Label.GROUND)).sum()
    expected = metrics.report(leave_unanswered_out=True)
    below = figures["below"]
    for name in ("iou", "precision", "recall", "f1"):
        assert below[name] == pytest.approx(100 * expected[name])
    assert below["ground"] == pytest.approx(100 * ground / answered)
    assert below["agrees"] == pytest.approx(100 * agreed / answered)
    assert figures["groundgrid"]["agrees"] == 100 and figures["groundgrid"]["iou"] > 90
    assert 0 < below["median_ms"] <= below["p95_ms"]


def test_the_table_names_what_is_not_installed(folder, capfd):
    assert main(["compare", str(folder), "--scans", "1"]) == 0
    lines = capfd.readouterr().out.splitlines()
    assert [line.split("  ")[0].strip() for line in lines[1:4]] == ["groundgrid",
                                                                   "groundgrid paper", "below"]
    assert "IoU" in lines[0] and len({len(line) for line in lines[:4]}) == 1
    assert lines[-1].startswith("Not installed: gone; pip install -r ")


@pytest.mark.parametrize(
    ("flags", "words"),
    [
        (["--methods", "gone"], "Gone cannot be loaded"),
        (["--methods", "best"], "--methods: expected some of groundgrid, groundgrid paper, below"),
    ],
)
def test_what_cannot_be_is_said(folder, capfd, flags, words):
    assert main(["compare", str(folder), *flags]) == 1
    out, error = capfd.readouterr()
    assert words in error and not out


def test_peers_need_a_sensor_height(folder, tmp_path, capfd):
    np.savez(tmp_path / "0.npz", points=np.full((4, 3), 3, np.float32))
    assert main(["compare", str(tmp_path / "0.npz"), "--methods", "below"]) == 1
    assert "say it with --sensor-height-m" in capfd.readouterr().err
    flags = ["--methods", "below", "--sensor-height-m", "1.7"]
    assert main(["compare", str(tmp_path / "0.npz"), *flags]) == 0


def test_without_peers_no_sensor_height_is_needed(folder, tmp_path, capfd, monkeypatch):
    monkeypatch.setattr(compare, "PEERS", {"gone": not_installed})
    np.savez(tmp_path / "0.npz", points=np.full((4, 3), 3, np.float32))
    assert main(["compare", str(tmp_path / "0.npz")]) == 0
    assert "Not installed: gone" in capfd.readouterr().out


def test_a_peer_that_is_not_installed_is_told():
    assert set(peers.PEERS) == {"patchwork++", "patchwork", "linefit", "travel", "csf", "csf 0.1 m",
                                "ransac plane"}
    with pytest.raises(peers.PeerMissing, match="linefit cannot be loaded"):
        peers.package("no_such_package", "linefit")
