"""What the viewer shows, and the recording that it is in."""

import json
import random
import re
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import pytest

import groundgrid
from groundgrid import Label, TerrainLayers, Traversability
from groundgrid.program.main import main
from groundgrid.viewer import Recording, colors
from groundgrid.viewer.layer_images import LAYERS, images_of
from groundgrid.viewer.terrain_mesh import closed, mesh_of


@pytest.fixture(autouse=True, scope="module")
def no_telemetry(tmp_path_factory):
    """Rerun's program would look for the server that counts its users; tests need no network."""
    folder = tmp_path_factory.mktemp("settings")
    file = folder / "rerun" / "analytics.json"
    file.parent.mkdir()
    file.write_text(json.dumps({
        "analytics_enabled": False, "analytics_id": "none", "metadata": {},
        "config_file_path": str(file), "data_dir_path": str(folder / "data")}))
    with pytest.MonkeyPatch.context() as environment:
        environment.setenv("XDG_CONFIG_HOME", str(folder))
        yield


@pytest.fixture
def grid(plane):
    grid = groundgrid.GroundGrid(sensor_height_m=1.5)
    grid.process(plane)
    return grid


def test_the_mesh_lies_on_the_terrain(grid):
    terrain = grid.terrain
    mesh = mesh_of(terrain, np.array([1.0, 0.0, 0.0]))
    assert len(mesh.vertices) == len(mesh.normals) == len(mesh.colors) > 1000
    assert mesh.triangles.max() == len(mesh.vertices) - 1
    np.testing.assert_allclose(mesh.vertices[:, 2], -1.5, atol=0.05)
    # Triangles are half a cell each, counter-clockwise from above.
    a, b, c = (mesh.vertices[mesh.triangles[:, i]] for i in range(3))
    area = np.cross(b - a, c - a)[:, 2] / 2
    np.testing.assert_allclose(area, terrain.resolution_m**2 / 2, rtol=1e-3)
    # The plane is 20 m wide, one metre further to the left by the origin.
    assert -11.2 < mesh.vertices[:, 0].min() < -10.3 and 8.3 < mesh.vertices[:, 0].max() < 9.2
    np.testing.assert_allclose(mesh.normals[:, 2], 1, atol=0.02)


def test_a_map_of_nothing_has_no_mesh():
    empty = groundgrid.GroundGrid(sensor_height_m=1.5)
    empty.process(np.full((1, 3), np.nan, np.float32))
    mesh = mesh_of(empty.terrain, np.zeros(3))
    assert len(mesh.vertices) == len(mesh.triangles) == 0


def test_small_gaps_are_closed_and_large_ones_stay():
    known = np.ones((20, 20), bool)
    known[5:8, 5:8] = False
    known[10:16, 10:16] = False
    known[0, :] = False
    filled = closed(known, 2)
    expected = known.copy()
    expected[5:8, 5:8] = True
    np.testing.assert_array_equal(filled, expected)


def test_images_have_north_at_the_top(grid, plane):
    layers = TerrainLayers()
    layers.update(grid)
    images = dict(images_of(grid.terrain, layers))
    assert tuple(images) == LAYERS
    for image in images.values():
        assert image.shape == (layers.size, layers.size, 3) and image.dtype == np.uint8
    below = layers.traversability[::-1]
    table = {value: tuple(color) for value, color in colors.TRAVERSABILITY.items()}
    for value in Traversability:
        assert (images["traversability"][below == value] == table[value]).all()
    unknown = grid.terrain.confidence[::-1] < 0.05
    assert (images["height"][unknown] == colors.NOT_KNOWN).all()
    assert not (images["height"][~unknown] == colors.NOT_KNOWN).all(axis=-1).any()


def test_colours_go_from_dark_to_bright():
    found = colors.by_value(np.array([-1.0, 0.0, 5.0, 10.0, 11.0, np.nan]), 0, 10)
    assert found[0].tolist() == found[1].tolist() == [68, 1, 84]
    assert found[3].tolist() == found[4].tolist() == [253, 231, 37]
    assert (np.diff(found[[1, 2, 3]].astype(int).sum(axis=1)) > 0).all()
    assert found[5].tolist() == list(colors.NOT_KNOWN)
    assert set(colors.LABELS) == set(Label)


@pytest.fixture(scope="module")
def folder(drive, tmp_path_factory):
    folder = tmp_path_factory.mktemp("drive")
    for number, scan in enumerate(drive):
        np.savez(folder / f"{number}.npz", points=scan.points, pose=scan.pose, time_s=number)
    return folder


def rows_of(recording):
    """Rows by entity, as Rerun's own program counts them."""
    command = [sys.executable, "-m", "rerun", "rrd", "print", "-v", str(recording)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found = {}
    for rows, entity in re.findall(r"with (\d+) rows .*?- (/\S+)", done.stdout):
        found[entity] = found.get(entity, 0) + int(rows)
    return found


def test_everything_is_in_the_recording(folder, tmp_path, capsys):
    output = tmp_path / "drive.rrd"
    assert main(["view", str(folder), "--output", str(output), "--terrain-every", "2"]) == 0
    assert "3 scans" in capsys.readouterr().out
    assert [each.name for each in tmp_path.iterdir()] == ["drive.rrd"]
    rows = rows_of(output)
    for label in Label:
        assert rows[f"/world/scan/{label.name.lower()}"] == 3
        assert rows[f"/share/{label.name.lower()}"] == 3
    assert rows["/time/process"] == 3 and rows["/world/path"] == 1
    for entity in ("/world/terrain", *(f"/layers/{name}" for name in LAYERS)):
        assert rows[entity] == 2, entity


def test_a_recording_that_fails_is_not_there(folder, tmp_path, capsys):
    bad = tmp_path / "bad"
    bad.mkdir()
    (bad / "0.npz").write_bytes((folder / "0.npz").read_bytes())
    (bad / "1.npz").write_bytes(b"no scan")
    assert main(["view", str(bad), "--output", str(tmp_path / "drive.rrd")]) == 1
    assert "1.npz: " in capsys.readouterr().err
    assert [each.name for each in tmp_path.iterdir()] == ["bad"]
    with pytest.raises(ValueError, match="no end"), Recording(tmp_path / "drive.rrd"):
        raise ValueError("no end")
    assert [each.name for each in tmp_path.iterdir()] == ["bad"]


def test_large_coordinates_lose_nothing(folder, tmp_path):
    recording = Recording(tmp_path / "drive.rrd")
    grid = groundgrid.GroundGrid()
    logged = {}
    with recording:
        recording._log = lambda place, what, static=False: logged.setdefault(place, what)
        scan = next(iter(groundgrid.datasets.open(folder)))
        pose = scan.pose.copy()
        pose[:3, 3] += [500000, 5000000, 100]
        moved = scan.at(pose)
        recording.add(moved, grid.process(moved.points, pose), grid)
    points = np.concatenate([
        logged[f"/world/scan/{label.name.lower()}"].positions.as_arrow_array().flatten()
        .to_numpy(zero_copy_only=False).reshape(-1, 3) for label in Label])
    finite = np.isfinite(scan.points[:, :3]).all(axis=1)
    expected = scan.points[finite, :3] @ pose[:3, :3].T + pose[:3, 3] - np.round(pose[:3, 3])
    assert len(points) == finite.sum()
    np.testing.assert_allclose(np.sort(points[:, 2]), np.sort(expected[:, 2]), atol=1e-5)


def test_a_recording_never_replaces_the_input(folder, tmp_path, capsys):
    scan = tmp_path / "0.npz"
    scan.write_bytes(next(folder.glob("*.npz")).read_bytes())
    before = scan.read_bytes()
    for source in (scan, tmp_path):
        assert main(["view", str(source), "--output", str(scan)]) == 1
        assert "0.npz: expected another file for --output" in capsys.readouterr().err
    assert scan.read_bytes() == before


def two_free_ports():
    """The first of two neighbours, below those that the system hands out to others meanwhile."""
    for port in random.Random().sample(range(20000, 32000, 2), 100):
        with socket.socket() as first, socket.socket() as second:
            try:
                first.bind(("127.0.0.1", port))
                second.bind(("127.0.0.1", port + 1))
            except OSError:
                continue
            return port
    pytest.fail("no two free ports beside each other")


def is_served(port):
    with socket.socket() as client:
        return client.connect_ex(("127.0.0.1", port)) == 0


def wait_until(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.05)


# Whoever runs the tests in the background may have had Ctrl-C ignored.
HEEDS_CTRL_C = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
from groundgrid.program.main import main
sys.exit(main())
"""


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 0), (signal.SIGTERM, 143), (signal.SIGHUP, 129)]
)
def test_the_server_ends_with_the_program(folder, tmp_path, number, code):
    port = two_free_ports()
    command = [sys.executable, "-c", HEEDS_CTRL_C, "view", str(folder), "--output",
               str(tmp_path / "drive.rrd"), "--web", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
        try:
            wait_until(lambda: is_served(port) and is_served(port + 1))
            program.send_signal(number)
            # Ends when the server has closed it, too.
            output, _ = program.communicate(timeout=60)
        finally:
            program.kill()
    assert program.returncode == code
    assert f"http://127.0.0.1:{port}?url=" in output
    wait_until(lambda: not is_served(port) and not is_served(port + 1))


def test_a_port_in_use_is_said(folder, tmp_path, capfd):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        command = ["view", str(folder), "--output", str(tmp_path / "drive.rrd"), "--web"]
        assert main([*command, "--port", str(port)]) == 1
    assert f"cannot serve {tmp_path / 'drive.rrd'} on port {port}" in capfd.readouterr().err
