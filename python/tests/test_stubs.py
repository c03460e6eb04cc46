"""The types and docs that editors and type checkers see."""

import ast
import inspect
import subprocess
import sys
from pathlib import Path

import groundgrid

PACKAGE = Path(groundgrid.__file__).parent

USAGE = """
import numpy as np
import numpy.typing as npt
import groundgrid
from groundgrid import Config, GroundGrid, Label

config: Config = Config(resolution_m=0.5, sensor_height_m=None).replace(min_range_m=1.0)
grid = GroundGrid(config, method="paper", threads=2)
result = grid.process(np.zeros((3, 3), np.float32), np.eye(4))
labels: npt.NDArray[np.uint8] = result.labels
heights: npt.NDArray[np.float64] = grid.terrain.height
height: float | None = result.sensor_height_m
label: int = Label.GROUND
for scan in groundgrid.simulation.Drive("urban", scans=2):
    points: npt.NDArray[np.float32] = scan.points
"""
WRONG = {
    'Config(resolution_m="wide")': "arg-type",
    "Config(cell_size=0.5)": "call-arg",
    "Config().own_variance_min_points.real.no": "attr-defined",
    "GroundGrid(threads=None)": "arg-type",
    "GroundGrid().process()": "call-arg",
    "Config().cell_sze_m = 0.5": "attr-defined",
}


def run(*arguments, cwd):
    folder = str(PACKAGE.parent)
    # mypy finds what is installed by itself, and wants it named nowhere else.
    is_installed = "site-packages" in PACKAGE.parent.parts
    return subprocess.run(
        [sys.executable, "-m", *arguments],
        cwd=cwd,
        env={} if is_installed else {"MYPYPATH": folder, "PYTHONPATH": folder},
        capture_output=True,
        text=True,
    )


def names_in_stub():
    for node in ast.parse((PACKAGE / "_core.pyi").read_text()).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        if isinstance(node, ast.ClassDef):
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield f"{node.name}.{member.name}"
                elif isinstance(member, ast.Assign | ast.AnnAssign):
                    target = getattr(member, "target", None) or member.targets[0]
                    yield f"{node.name}.{target.id}"


def names_in_module():
    for name, thing in vars(groundgrid._core).items():
        if callable(thing) and not name.startswith("_"):
            yield name
            members = vars(thing) if inspect.isclass(thing) else ()
            yield from (f"{name}.{member}" for member in members if not member.startswith("_"))


def test_the_stub_has_the_names_of_the_module():
    in_stub = {name for name in names_in_stub() if "._" not in name}
    assert in_stub == set(names_in_module())


def test_the_package_is_typed(tmp_path):
    result = run("mypy", "--strict", "--no-incremental", "-p", "groundgrid", cwd=tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert (PACKAGE / "py.typed").exists()


def test_a_type_checker_tells_right_from_wrong(tmp_path):
    lines = USAGE.splitlines() + list(WRONG)
    (tmp_path / "usage.py").write_text("\n".join(lines) + "\n")
    result = run("mypy", "--strict", "--no-incremental", "usage.py", cwd=tmp_path)
    errors = [line for line in result.stdout.splitlines() if ": error:" in line]
    first_wrong = len(USAGE.splitlines()) + 1
    expected = [(first_wrong + i, code) for i, code in enumerate(WRONG.values())]
    found = [(int(line.split(":")[1]), line.split("[")[-1].rstrip("]")) for line in errors]
    assert found == expected, result.stdout + result.stderr


def public_things():
    for module in (groundgrid, groundgrid.evaluation, groundgrid.simulation):
        yield module.__name__, module
        for name in module.__all__:
            thing = getattr(module, name)
            if isinstance(thing, str) or inspect.ismodule(thing):
                continue
            yield name, thing
            if inspect.isclass(thing):
                for member in vars(thing):
                    if not member.startswith("_"):
                        yield f"{name}.{member}", getattr(thing, member)


def test_everything_public_says_what_it_is():
    silent = [name for name, thing in public_things() if not inspect.getdoc(thing)]
    assert not silent


def test_every_keyword_is_in_the_signature_of_the_stub():
    stub = (PACKAGE / "_core.pyi").read_text()
    for parameter in groundgrid.parameters():
        # Config(), Config.replace() and GroundGrid()
        assert stub.count(f", {parameter.name}: ") >= 3, parameter.name
