import copy
import math
import pickle

import numpy as np
import pytest

import groundgrid
from groundgrid import Config


def test_every_parameter_is_a_keyword_and_an_attribute():
    parameters = groundgrid.parameters()
    assert len(parameters) == 20
    for parameter in parameters:
        assert getattr(Config(), parameter.name) == parameter.default
        lists = {"anchor_m": (1.0, 2.0), "ego_vehicle_box_m": (-1.0, 1.0, -2.0, 2.0, -3.0, 3.0)}
        value = parameter.default if parameter.default is not None else lists.get(
            parameter.name, 1.0)
        assert getattr(Config(**{parameter.name: value}), parameter.name) == value


def test_parameters_tell_unit_range_and_symbol():
    cell = {parameter.name: parameter for parameter in groundgrid.parameters()}["resolution_m"]
    assert (cell.default, cell.unit, cell.min, cell.max) == (0.33, "m", 0.02, 10.0)
    assert (cell.symbol, cell.stage, cell.text) == ("R", "map", "Side of a cell.")
    assert repr(cell) == "Parameter(resolution_m: Side of a cell. (paper: R, m))"


def test_attributes_can_be_set():
    config = Config()
    config.resolution_m = 0.5
    config.sensor_height_m = np.float32(1.5)
    config.method = "paper"
    config.own_variance_min_points = np.int64(7)
    config.anchor_m = (1.0, 2)
    config.ego_vehicle_box_m = np.array([-1.0, 3.0, -1.0, 1.0, -2.0, 0.5])
    assert config.ego_vehicle_box_m == (-1.0, 3.0, -1.0, 1.0, -2.0, 0.5)
    assert config == Config(resolution_m=0.5, sensor_height_m=1.5, method="paper",
                            own_variance_min_points=7, anchor_m=[1.0, 2.0],
                            ego_vehicle_box_m=(-1.0, 3.0, -1.0, 1.0, -2.0, 0.5))
    config.sensor_height_m = None
    assert config.sensor_height_m is None


@pytest.mark.parametrize(
    ("values", "error", "words"),
    [
        ({"cell_size": 0.5}, TypeError, "unknown parameter 'cell_size'"),
        ({"resolution_m": 20}, ValueError, "resolution_m = 20: must be between 0.02 and 10"),
        ({"resolution_m": math.nan}, ValueError, "resolution_m = nan"),
        ({"resolution_m": math.inf}, ValueError, "resolution_m = inf"),
        ({"resolution_m": "wide"}, TypeError, "resolution_m: expected float, got str"),
        ({"resolution_m": True}, TypeError, "resolution_m: expected float, got bool"),
        ({"resolution_m": None}, TypeError, "resolution_m: expected float, got NoneType"),
        ({"sensor_height_m": "low"}, TypeError, r"sensor_height_m: expected float \| None"),
        ({"own_variance_min_points": 1.5}, TypeError, "points: expected int, got float"),
        ({"own_variance_min_points": -1}, ValueError, "own_variance_min_points = -1"),
        ({"own_variance_min_points": 2**40}, ValueError, "points = 1099511627776"),
        ({"anchor_m": 1.0}, TypeError, r"anchor_m: expected tuple\[float, float\] \| None"),
        ({"anchor_m": (1.0,)}, TypeError, "anchor_m: expected tuple"),
        ({"anchor_m": (1.0, math.nan)}, ValueError, "anchor_m = nan"),
        ({"ego_vehicle_box_m": (1, -1, -1, 1, -1, 1)}, ValueError, "below the greatest"),
        ({"cell_size_m": 0.5}, TypeError, "'cell_size_m': it is resolution_m now"),
        ({"method": 1}, TypeError, "method: expected str, got int"),
        ({"method": "ours"}, ValueError, "method = ours: must be standard, paper or reference"),
        ({"extent_m": 2000, "resolution_m": 0.02}, ValueError, "9 to 4096 cells"),
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
    with pytest.raises(ValueError, match="resolution_m"):
        config.resolution_m = -1
    assert config == Config()


def test_values_that_only_go_together_can_be_given_together():
    assert Config().replace(extent_m=2000.0, resolution_m=1.0).extent_m == 2000.0
    with pytest.raises(ValueError, match="9 to 4096 cells"):
        Config().replace(extent_m=2000.0)


def test_presets():
    assert Config.preset("default") == Config()
    assert Config.preset("paper") == Config.paper()
    assert Config.paper().ground_threshold_m == 0.3
    with pytest.raises(ValueError, match="expected 'default' or 'paper', got 'best'"):
        Config.preset("best")


def test_pickles_and_copies():
    config = Config.paper().replace(sensor_height_m=1.73, anchor_m=(0.0, 3.0))
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps(config, protocol)) == config
    assert copy.copy(config) == config
    deep = copy.deepcopy(config)
    deep.anchor_m = None
    assert deep != config
    assert Config(**config.to_dict()) == config


def test_equality_repr_and_hash():
    assert Config() != 3
    assert Config() != None  # noqa: E711
    assert repr(Config()) == "Config()"
    assert repr(Config(resolution_m=0.5, method="paper")) == (
        "Config(method='paper', resolution_m=0.5)"
    )
    with pytest.raises(TypeError, match="unhashable"):
        hash(Config())


def test_reads_parameter_files(tmp_path):
    file = tmp_path / "parameters.toml"
    file.write_text('resolution_m = 0.5 # wide\nsensor_height_m = 1.73\nmethod = "paper"\n')
    expected = {"resolution_m": 0.5, "sensor_height_m": 1.73, "method": "paper"}
    assert Config.from_toml(file) == Config(**expected)
    assert Config.from_toml(str(file), preset="paper") == Config.paper().replace(**expected)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("resolution_m = 20", "line 1: resolution_m = 20: must be between"),
        ("\ncell_size = 0.5", "line 2: unknown parameter 'cell_size'"),
        ("min_range_m = 1\nmin_range_m = 1", "line 2: min_range_m is given for the second time"),
        ("resolution_m = [1]", r"line 1: resolution_m = \[1\]: not a number"),
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
