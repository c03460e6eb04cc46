"""Whatever is handed over, the answer is a result or an error that says what was expected."""

import hypothesis.extra.numpy as arrays
import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import groundgrid
from groundgrid import Config, GroundGrid
from groundgrid.evaluation import SegmentationMetrics, compare_terrain

ERRORS = (TypeError, ValueError)
ANY_SPEED = settings(
    deadline=None,
    max_examples=150,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
SMALL = {"extent_m": 20.0, "resolution_m": 0.5, "sensor_height_m": 1.5}

any_dtype = st.one_of(
    arrays.floating_dtypes(),
    arrays.integer_dtypes(),
    arrays.unsigned_integer_dtypes(),
    arrays.boolean_dtypes(),
    arrays.complex_number_dtypes(),
    arrays.byte_string_dtypes(),
)
any_array = arrays.arrays(any_dtype, arrays.array_shapes(min_dims=0, max_dims=4, min_side=0))
any_object = st.one_of(
    any_array, st.none(), st.integers(), st.floats(), st.text(), st.binary(), st.lists(st.floats())
)
numbers = st.one_of(
    st.floats(-15, 15, width=32),
    st.sampled_from([0.0, -0.0, np.nan, np.inf, -np.inf, 1e-40, 3.4e38, -1.5]),
)


@st.composite
def point_arrays(draw):
    """N × 3 to 6 floats, of any byte order, in a window of a larger array with any steps."""
    dtype = draw(st.sampled_from(["<f4", ">f4", "<f8", ">f8"]))
    rows, columns = draw(st.integers(0, 30)), draw(st.integers(3, 6))
    row_step = draw(st.sampled_from([-3, -2, -1, 1, 2, 5]))
    column_step = draw(st.sampled_from([-2, -1, 1, 3]))
    shape = (rows * abs(row_step) + 1, columns * abs(column_step))
    order = draw(st.sampled_from("CF"))
    values = draw(arrays.arrays(np.float32, (rows, columns), elements=numbers))
    memory = np.zeros(shape, dtype, order=order)
    offset = draw(st.booleans())
    if offset:  # not aligned
        raw = np.zeros(memory.nbytes + 1, np.uint8)[1:]
        memory = np.ndarray(shape, dtype, raw.data, order=order)
    window = memory[: rows * abs(row_step)][::row_step, ::column_step]
    window[...] = values
    return window, values


@ANY_SPEED
@given(point_arrays())
def test_the_layout_of_points_changes_nothing(pair):
    window, values = pair
    window.flags.writeable = False
    result = GroundGrid(**SMALL).process(window)
    expected = GroundGrid(**SMALL).process(np.ascontiguousarray(values))
    np.testing.assert_array_equal(result.labels, expected.labels)
    np.testing.assert_array_equal(result.height_above_ground, expected.height_above_ground)
    unknown = ~np.all(np.isfinite(values[:, :3]), axis=1)
    assert np.all(result.labels[unknown] == groundgrid.Label.UNKNOWN)


@ANY_SPEED
@given(st.data())
def test_any_arguments_of_process_give_a_result_or_an_error(data):
    grid = GroundGrid(**SMALL)
    points = data.draw(st.one_of(any_object, point_arrays().map(lambda pair: pair[0])))
    names = ["pose", "mounting", "times", "time_span", "pose_begin", "out"]
    chosen = data.draw(st.lists(st.sampled_from(names), unique=True, max_size=3))
    arguments = {name: data.draw(any_object, label=name) for name in chosen}
    try:
        result = grid.process(points, **arguments)
    except ERRORS as error:
        assert str(error)
        assert grid.terrain.size == 0
        return
    assert len(result.labels) == len(result.height_above_ground) == len(points)
    assert np.all(result.labels <= 3)


@ANY_SPEED
@given(
    st.dictionaries(st.sampled_from([p.name for p in groundgrid.parameters()]), any_object),
)
def test_any_value_of_a_parameter_is_taken_or_refused(values):
    try:
        config = Config(**values)
    except ERRORS as error:
        assert str(error)
        return
    assert Config(**config.to_dict()) == config


@settings(ANY_SPEED, max_examples=30)
@given(st.data())
def test_any_valid_configuration_works(data):
    values = {}
    for parameter in groundgrid.parameters():
        if parameter.name in ("extent_m", "resolution_m"):
            continue
        if parameter.stage == "paper" and values["method"] != "paper":
            continue
        if parameter.name == "method":
            values["method"] = data.draw(st.sampled_from(["standard", "paper", "reference"]))
        elif parameter.name == "ego_vehicle_box_m":
            sides = [sorted(data.draw(st.tuples(st.floats(-99, 0), st.floats(1, 99))))
                     for _ in range(3)]
            values[parameter.name] = tuple(number for side in sides for number in side)
        elif parameter.name == "anchor_m":
            values[parameter.name] = data.draw(st.tuples(st.floats(-1e8, 1e8),
                                                         st.floats(-1e8, 1e8)))
        elif isinstance(parameter.default, int):
            values[parameter.name] = data.draw(st.integers(int(parameter.min), int(parameter.max)))
        else:
            values[parameter.name] = data.draw(st.floats(parameter.min, parameter.max))
    if values["method"] == "paper":
        values["max_step_m"] = 0.0  # the paper knows no steps
    grid = GroundGrid(extent_m=20.0, resolution_m=0.5, **values)
    points = np.random.default_rng(0).uniform(-9, 9, (500, 3)).astype(np.float32)
    assert len(grid.process(points).labels) == 500
    assert grid.terrain.height.shape == (grid.terrain.size,) * 2


@ANY_SPEED
@given(any_object, any_object, any_object, any_object)
def test_any_labels_are_scored_or_refused(points, truth, predicted, heights):
    try:
        SegmentationMetrics().add_scan(points, truth, predicted, heights)
    except ERRORS as error:
        assert str(error)


@ANY_SPEED
@given(any_object, any_object, st.floats(), any_object, any_object)
def test_any_terrains_are_compared_or_refused(estimated, reference, resolution_m, density, path):
    try:
        compare_terrain(estimated, reference, resolution_m, density=density, path=path)
    except ERRORS as error:
        assert str(error)
