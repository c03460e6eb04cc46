import copy
import math
import pickle

import numpy as np
import pytest

import groundgrid
from groundgrid import Config


def test_every_parameter_is_a_keyword_and_an_attribute():
    parameters = groundgrid.parameters()
    assert len(parameters) > 20
    for parameter in parameters:
        assert getattr(Config(), parameter.name) == parameter.default
        value = parameter.default if parameter.default is not None else 1.0
        assert getattr(Config(**{parameter.name: value}), parameter.name) == value


def test_parameters_tell_unit_range_and_symbol():
    cell = {parameter.name: parameter for parameter in groundgrid.parameters()}["cell_size_m"]
    assert (cell.default, cell.unit, cell.min, cell.max) == (0.33, "m", 0.02, 10.0)
    assert (cell.symbol, cell.stage, cell.text) == ("R", "map", "Side of a cell.")
    assert repr(cell) == "Parameter(cell_size_m: Side of a cell. (paper: R, m))"


def test_attributes_can_be_set():
    config = Config()
    config.cell_size_m = 0.5
    config.sensor_height_m = np.float32(1.5)
    config.method = "paper"
    config.threads = np.int64(2)
    assert config == Config(cell_size_m=0.5, sensor_height_m=1.5, method="paper", threads=2)
    config.sensor_height_m = None
    assert config.sensor_height_m is None


@pytest.mark.parametrize(
    ("values", "error", "words"),
    [
        ({"cell_size": 0.5}, TypeError, "unknown parameter 'cell_size'"),
        ({"cell_size_m": 20}, ValueError, "cell_size_m = 20: must be between 0.02 and 10"),
        ({"cell_size_m": math.nan}, ValueError, "cell_size_m = nan"),
        ({"cell_size_m": math.inf}, ValueError, "cell_size_m = inf"),
        ({"cell_size_m": "wide"}, TypeError, "cell_size_m: expected float, got str"),
        ({"cell_size_m": True}, TypeError, "cell_size_m: expected float, got bool"),
        ({"cell_size_m": None}, TypeError, "cell_size_m: expected float, got NoneType"),
        ({"sensor_height_m": "low"}, TypeError, r"sensor_height_m: expected float \| None"),
        ({"threads": 1.5}, TypeError, "threads: expected int, got float"),
        ({"threads": -1}, ValueError, "threads = -1"),
        ({"threads": 2**40}, ValueError, "threads = 1099511627776"),
        ({"method": 1}, TypeError, "method: expected str, got int"),
        ({"method": "ours"}, ValueError, "method = ours: must be standard, paper or reference"),
        ({"map_extent_m": 2000, "cell_size_m": 0.02}, ValueError, "9 to 4096 cells"),
    ],
)
def test_bad_values_are_refused_by_name(values, error, words):
    with pytest.raises(error, match=words):
        Config(**values)
    with pytest.raises(error, match=words):
        Config().replace(**values)
    with pytest.raises(error, match=words):
        groundgrid.GroundGrid(**values)


def test_a_refused_attribute_changes_nothing():
    config = Config()
    with pytest.raises(ValueError, match="cell_size_m"):
        config.cell_size_m = -1
    assert config == Config()


def test_values_that_only_go_together_can_be_given_together():
    assert Config().replace(map_extent_m=2000.0, cell_size_m=1.0).map_extent_m == 2000.0
    with pytest.raises(ValueError, match="9 to 4096 cells"):
        Config().replace(map_extent_m=2000.0)


def test_presets():
    assert Config.preset("default") == Config()
    assert Config.preset("paper") == Config.paper()
    assert Config.paper().ground_threshold_m == 0.3
    with pytest.raises(ValueError, match="expected 'default' or 'paper', got 'best'"):
        Config.preset("best")


def test_pickles_and_copies():
    config = Config.paper().replace(sensor_height_m=1.73, threads=3)
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps(config, protocol)) == config
    assert copy.copy(config) == config
    deep = copy.deepcopy(config)
    deep.threads = 1
    assert deep != config
    assert Config(**config.to_dict()) == config


def test_equality_repr_and_hash():
    assert Config() != 3
    assert Config() != None  # noqa: E711
    assert repr(Config()) == "Config()"
    assert repr(Config(cell_size_m=0.5, method="paper")) == (
        "Config(method='paper', cell_size_m=0.5)"
    )
    with pytest.raises(TypeError, match="unhashable"):
        hash(Config())


def test_reads_parameter_files(tmp_path):
    file = tmp_path / "parameters.toml"
    file.write_text('cell_size_m = 0.5 # wide\nsensor_height_m = 1.73\nmethod = "paper"\n')
    expected = {"cell_size_m": 0.5, "sensor_height_m": 1.73, "method": "paper"}
    assert Config.from_toml(file) == Config(**expected)
    assert Config.from_toml(str(file), preset="paper") == Config.paper().replace(**expected)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("cell_size_m = 20", "line 1: cell_size_m = 20: must be between"),
        ("\ncell_size = 0.5", "line 2: unknown parameter 'cell_size'"),
        ("threads = 1\nthreads = 1", "line 2: threads is given for the second time"),
        ("cell_size_m = [1]", "line 1: cell_size_m: expected one number"),
    ],
)
def test_bad_parameter_files_are_refused_with_the_line(tmp_path, text, words):
    file = tmp_path / "parameters.toml"
    file.write_text(text)
    with pytest.raises(ValueError, match=words):
        Config.from_toml(file)


def test_parameter_files_must_be_there(tmp_path):
    with pytest.raises(FileNotFoundError, match="nothing.toml"):
        Config.from_toml(tmp_path / "nothing.toml")
    with pytest.raises(TypeError):
        Config.from_toml(3.5)
    with pytest.raises(ValueError, match="expected 'default' or 'paper'"):
        Config.from_toml(tmp_path / "nothing.toml", preset="best")
