"""groundgrid-py's output in bad times: full disks, two runs at once, runs that were killed."""

import fcntl
import json
import os
import resource
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from test_bags import STORE, cloud, write

import groundgrid
from groundgrid import _core
from groundgrid.program.clouds import write_las, write_pcl
from groundgrid.program.main import main
from groundgrid.rasters import TerrainMosaic

IN_USE = "expected a folder that no other run writes to, got one that is in use"


@pytest.fixture(scope="module")
def scans(drive, tmp_path_factory):
    folder = tmp_path_factory.mktemp("scans")
    for number, scan in enumerate(drive):
        np.savez(folder / f"{number}.npz", points=scan.points, pose=scan.pose)
    return folder


@pytest.fixture
def answered(drive):
    grid = groundgrid.GroundGrid()
    scan = drive[0]
    fields = dict(zip("xyz", scan.points[:, :3].T))
    return (groundgrid.datasets.Scan("a", scan.points, scan.pose, fields=fields), grid,
            grid.process(scan.points, scan.pose))


def terrain_of(grid, path):
    terrain = TerrainMosaic(path)
    terrain.add(grid)
    terrain.finish()



@contextmanager
def limited(size):
    """Lets no file grow beyond so many bytes, which is what a full disk is to those who write."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.mark.parametrize("size", [0, 100, 5000])
@pytest.mark.parametrize("ending", ["label", "pcd", "ply", "las", "laz", "tif"])
def test_a_writer_on_a_full_disk_leaves_the_old_file(tmp_path, answered, ending, size):
    scan, grid, result = answered
    write_it = {
        "label": lambda path: _core.write_labels(path, np.zeros(len(scan.points), np.uint32)),
        "pcd": lambda path: write_pcl(path, scan, result),
        "ply": lambda path: write_pcl(path, scan, result),
        "las": lambda path: write_las(path, scan, result, None),
        "laz": lambda path: write_las(path, scan, result, None),
        "tif": lambda path: terrain_of(grid, path),
    }[ending]
    path = tmp_path / f"a.{ending}"
    path.write_text("old")
    with limited(size), pytest.raises((ValueError, OSError)):
        write_it(path)
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    assert path.read_text() == "old"


def run_limited(size, *arguments):
    code = (f"import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, ({size}, {size}));"
            "from groundgrid.program.main import main; sys.exit(main())")
    return subprocess.run([sys.executable, "-c", code, *map(str, arguments)], capture_output=True,
                          text=True, check=False)


@pytest.mark.parametrize("flags", [[], ["--clouds", "laz"], ["--terrain"], ["--bag"]])
def test_a_run_on_a_full_disk_leaves_nothing_half(drive, tmp_path, flags):
    message = cloud(STORE, "plain", 0, 0, "lidar")
    bag = write(tmp_path / "drive", [("/points", message, 0)], "MCAP")
    out = tmp_path / "out"
    done = run_limited(20, "run", bag, "--output", out, *flags)
    assert done.returncode == 1 and "groundgrid-py: " in done.stderr, done.stderr
    assert not list(out.iterdir())


def test_a_recording_on_a_full_disk_leaves_nothing(scans, tmp_path):
    done = run_limited(1000, "view", scans, "--output", tmp_path / "a.rrd")
    assert done.returncode == 1 and "a.rrd: cannot be written: " in done.stderr, done.stderr
    assert not list(tmp_path.iterdir())


def test_a_folder_that_another_run_writes_to_is_refused(scans, tmp_path, capsys):
    flags = ["run", str(scans), "--output", str(tmp_path)]
    assert main(flags) == 0
    before = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    # As the program groundgrid has it.
    with (tmp_path / ".groundgrid.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        assert main(flags) == 1
        assert f"{tmp_path}: {IN_USE}" in capsys.readouterr().err
        os.unlink(tmp_path / ".groundgrid.lock")
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == before
    assert main(flags) == 0


def test_what_killed_runs_left_goes(scans, tmp_path):
    flags = ["run", str(scans), "--output", str(tmp_path)]
    assert main(flags) == 0
    whole = sorted(each.name for each in tmp_path.iterdir())
    (tmp_path / ".groundgrid.lock").touch()
    (tmp_path / ".groundgrid-0123456789abcdef.tmp").write_text("half")
    assert main(flags) == 0
    assert sorted(each.name for each in tmp_path.iterdir()) == whole


# One of them may be done before the other one begins.
def test_two_runs_at_once_leave_one_whole_answer(scans, tmp_path):
    flags = ["run", str(scans), "--clouds", "laz", "--terrain", "--output"]
    assert main([*flags, str(tmp_path / "one")]) == 0
    whole = sorted(each.name for each in (tmp_path / "one").iterdir())
    program = [sys.executable, "-m", "groundgrid.program.main", *flags, str(tmp_path / "both")]
    runs = [subprocess.Popen(program, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            for _ in range(2)]
    words = [run.communicate()[1] for run in runs]
    codes = [run.returncode for run in runs]
    assert 0 in codes and all(code == 0 or IN_USE in said for code, said in zip(codes, words)), words
    assert sorted(each.name for each in (tmp_path / "both").iterdir()) == whole
    for name in whole:
        if name.endswith((".label", ".tif")):
            assert (tmp_path / "both" / name).read_bytes() == (tmp_path / "one" / name).read_bytes()
    assert json.loads((tmp_path / "both" / "run.json").read_text())["scans"] == 3


def poses_of(drive):
    return "".join(" ".join(f"{number:.9g}" for number in scan.pose[:3].ravel()) + "\n"
                   for scan in drive)


@pytest.mark.parametrize("name", ["run.json", "terrain.tif", "1.label", "1.pcd"])
@pytest.mark.parametrize("option", ["--poses", "--config"])
def test_inputs_are_kept_whatever_name_they_have(drive, tmp_path, capsys, option, name):
    folder, out, given = tmp_path / "scans", tmp_path / "out", tmp_path / "given"
    folder.mkdir()
    out.mkdir()
    for number, scan in enumerate(drive):
        np.savez(folder / f"{number}.npz", points=scan.points)
    given.write_text({"--poses": poses_of(drive), "--config": "max_step_m = 0.1\n"}[option])
    os.link(given, out / name)
    before = given.read_text()
    flags = ["--output", str(out), "--terrain", "--clouds", "pcd", option, str(given)]
    assert main(["run", str(folder), *flags]) == 1
    assert f"{name}: expected another file for --output than the input" in capsys.readouterr().err
    assert (out / name).read_text() == before and (out / name).samefile(given)


def test_a_dataset_keeps_its_poses_and_labels(drive, tmp_path, capsys):
    sequence, out = tmp_path / "drive" / "sequences" / "00", tmp_path / "out"
    for name in ("velodyne", "labels"):
        (sequence / name).mkdir(parents=True)
    for number, scan in enumerate(drive):
        scan.points.tofile(sequence / "velodyne" / f"{number:06}.bin")
        np.zeros(len(scan.points), np.uint32).tofile(sequence / "labels" / f"{number:06}.label")
    (sequence / "poses.txt").write_text(poses_of(drive))
    (sequence / "calib.txt").write_text("Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n")
    out.mkdir()
    for input_file in ("poses.txt", "calib.txt", "labels/000001.label"):
        os.link(sequence / input_file, out / "run.json")
        assert main(["run", str(tmp_path / "drive"), "--output", str(out)]) == 1
        assert "run.json: expected another file for --output" in capsys.readouterr().err
        assert (out / "run.json").samefile(sequence / input_file)
        (out / "run.json").unlink()


def test_a_recording_in_the_viewer_keeps_the_parameter_file(scans, tmp_path, capsys):
    config = Path(tmp_path / "config.toml")
    config.write_text("max_step_m = 0.1\n")
    os.link(config, tmp_path / "a.rrd")
    flags = ["--config", str(config), "--output", str(tmp_path / "a.rrd")]
    assert main(["view", str(scans), *flags]) == 1
    assert "a.rrd: expected another file for --output" in capsys.readouterr().err
    assert config.read_text() == "max_step_m = 0.1\n"
