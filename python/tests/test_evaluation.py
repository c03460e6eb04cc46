import numpy as np
import pytest

from groundgrid import Label
from groundgrid.evaluation import SegmentationMetrics, compare_terrain, to_semantic_kitti

POINTS = np.array([[5.0, 0, 0], [5, 0, 0], [15, 0, 0], [15, 0, 0], [15, 0, 0]])
# road, road, building, terrain, unlabeled
TRUTH = np.array([40, 40 + (7 << 16), 50, 72, 0])
PREDICTED = np.array([40, 99, 40, 0, 40])


def test_counts_as_the_paper_does():
    metrics = SegmentationMetrics()
    metrics.add_scan(POINTS, TRUTH, PREDICTED)
    report = metrics.report()
    assert [report[name] for name in ("tp", "fp", "fn", "tn")] == [1, 1, 2, 0]
    assert (report["points"], report["unanswered"]) == (4, 1)
    assert report["iou"] == 1 / 4
    assert [row["name"] for row in report["classes"]] == [
        "unlabeled",
        "road",
        "building",
        "terrain",
    ]
    assert report["distances"][1]["points"] == 2
    left_out = metrics.report(leave_unanswered_out=True)
    assert left_out["iou"] == 1 / 3


def test_pools_scans_and_metrics():
    one, other = SegmentationMetrics(), SegmentationMetrics()
    one.add_scan(POINTS.astype(np.float32), TRUTH.astype(np.uint32), PREDICTED.astype(np.uint8))
    other.add_scan(np.asfortranarray(POINTS), TRUTH.tolist() and TRUTH, PREDICTED[::1])
    one.add(other)
    one.add(one)
    assert one.report()["tp"] == 4


def test_counts_high_grass_apart():
    metrics = SegmentationMetrics()
    metrics.add_scan(POINTS, TRUTH, PREDICTED, heights=[0, 0, 0, 0.5, 0] @ np.eye(5))
    assert metrics.report()["without_high_grass"]["points"] == 3


def test_nothing_counted_has_no_ratio():
    report = SegmentationMetrics().report()
    assert report["points"] == 0 and report["iou"] is None


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ((POINTS[:, 0], TRUTH, PREDICTED), ValueError, "points: expected rows with x, y"),
        ((POINTS[:, :1], TRUTH, PREDICTED), ValueError, "points: expected rows with x, y"),
        ((POINTS, TRUTH[:4], PREDICTED), ValueError, "truth: expected 5 numbers"),
        ((POINTS, TRUTH, PREDICTED[:4]), ValueError, "predicted: expected 5 numbers"),
        ((POINTS, TRUTH, PREDICTED, np.zeros(4)), ValueError, "heights: expected 5 numbers"),
        ((POINTS, TRUTH.astype(float), PREDICTED), TypeError, "truth: expected .* integers"),
        ((POINTS, TRUTH, -PREDICTED), ValueError, "predicted: expected labels from 0"),
        ((POINTS, TRUTH << 20, PREDICTED), ValueError, "truth: expected labels from 0"),
        ((POINTS, TRUTH, [40] * 5), TypeError, "predicted: expected .* got list"),
        ((None, TRUTH, PREDICTED), TypeError, "points: expected .* got NoneType"),
        ((POINTS.astype(str), TRUTH, PREDICTED), TypeError, "points"),
    ],
)
def test_other_scans_are_refused(arguments, error, words):
    metrics = SegmentationMetrics()
    with pytest.raises(error, match=words):
        metrics.add_scan(*arguments)
    assert metrics.report()["points"] == 0


def test_labels_as_in_label_files():
    labels = np.array([Label.UNKNOWN, Label.GROUND, Label.OBSTACLE, Label.OUTLIER], np.uint8)
    classes = to_semantic_kitti(labels)
    assert classes.dtype == np.uint32
    assert classes.tolist() == [0, 40, 99, 1]
    assert to_semantic_kitti(labels[:0]).shape == (0,)
    with pytest.raises(ValueError, match="0 to 3, got 4"):
        to_semantic_kitti(np.array([4]))
    with pytest.raises(ValueError, match="one number a point"):
        to_semantic_kitti(np.zeros((2, 2), np.uint8))


def test_compares_terrains():
    reference = np.zeros((3, 4))
    estimated = np.full((3, 4), 0.5)
    estimated[0, 0] = np.nan
    estimated[2, 3] = 0.9
    figures = compare_terrain(
        estimated,
        reference,
        0.5,
        density=np.where(np.arange(12).reshape(3, 4) < 4, 40, 1),
        count=np.ones((3, 4)),
        path=[[0.1, 0.1]] @ np.eye(2),
        masks={"corner": estimated == 0.9},
    )
    everything = figures["all"]
    assert (everything["cells"], everything["covered"]) == (12, 11)
    assert everything["bias_m"] == pytest.approx((10 * 0.5 + 0.9) / 11)
    assert figures["density"]["dense"]["cells"] == 4
    assert figures["masks"][0]["rmse_m"] == pytest.approx(0.9)
    assert figures["path_distance"][0]["cells"] == 12
    solved = compare_terrain(estimated, reference, 0.5, solve_offset=True)
    assert solved["offset"]["median_m"] == 0.5
    assert solved["density"] is None and solved["path_distance"] is None


def test_judges_standard_deviations():
    errors = np.array([[0.05, -0.05, 0.15, 0.5]])
    figures = compare_terrain(
        errors, np.zeros((1, 4)), 1.0, standard_deviation=np.full((1, 4), 0.1)
    )["standard_deviation"]["all"]
    assert (figures["cells"], figures["within_one"], figures["within_two"]) == (4, 0.5, 0.75)
    assert figures["median_m"] == pytest.approx(0.1)


def test_the_path_may_be_in_the_terrains_frame():
    flat = np.zeros((4, 40))
    near = compare_terrain(flat, flat, 1.0, path=np.array([[100.5, 51.5]]), corner_m=(100, 50))
    assert near["path_distance"][0]["cells"] < flat.size
    with pytest.raises(ValueError, match="path: none of it lies inside"):
        compare_terrain(flat, flat, 1.0, path=np.array([[np.nan, 0.0], [1e30, 3.0]]))


@pytest.mark.parametrize(
    ("arguments", "keywords", "error", "words"),
    [
        ((np.zeros(4), np.zeros(4), 1.0), {}, ValueError, "estimated: expected rows × columns"),
        ((np.zeros((2, 2)), np.zeros((2, 3)), 1.0), {}, ValueError, "reference: expected the shape"),
        ((np.zeros((2, 2)), np.zeros((2, 2)), 0.0), {}, ValueError, "resolution_m"),
        ((np.zeros((2, 2)), np.zeros((2, 2)), float("nan")), {}, ValueError, "resolution_m"),
        ((None, np.zeros((2, 2)), 1.0), {}, TypeError, "estimated"),
        (
            (np.zeros((2, 2)), np.zeros((2, 2)), 1.0),
            {"masks": {"kerbs": np.zeros(3)}},
            ValueError,
            "kerbs: expected the shape",
        ),
        (
            (np.zeros((2, 2)), np.zeros((2, 2)), 1.0),
            {"density": "dense"},
            TypeError,
            "density: expected an array of numbers",
        ),
    ],
)
def test_other_terrains_are_refused(arguments, keywords, error, words):
    with pytest.raises(error, match=words):
        compare_terrain(*arguments, **keywords)


def test_empty_terrains_have_no_figures():
    assert compare_terrain(np.zeros((0, 3)), np.zeros((0, 3)), 1.0)["all"]["rmse_m"] is None
