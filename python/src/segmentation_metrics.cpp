#include "evaluation/segmentation_metrics.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "array_input.hpp"
#include "array_output.hpp"
#include "bindings.hpp"
#include "evaluation/report.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "json_output.hpp"

namespace groundgrid::python {
namespace {

using evaluation::SegmentationMetrics;
using evaluation::Unanswered;

void require_length(const PackedArray& array, const char* name, std::size_t points) {
  if (array.dimensions() == 1 && array.size() == points) return;
  throw nb::value_error((std::string(name) + ": expected " + std::to_string(points) +
                         " numbers, one a point, got " + description_of(array.array()).c_str())
                            .c_str());
}

void add_scan(SegmentationMetrics& self, nb::handle points, nb::handle truth, nb::handle predicted,
              nb::handle heights) {
  const PackedArray places = PackedArray::floats(points, "points");
  if (places.dimensions() != 2 || places.length(1) < 2)
    throw nb::value_error((std::string("points: expected rows with x, y first, got ") +
                           description_of(places.array()).c_str())
                              .c_str());
  const std::size_t count = places.length(0);
  const PackedArray true_labels = PackedArray::labels(truth, "truth");
  const PackedArray answers = PackedArray::labels(predicted, "predicted");
  require_length(true_labels, "truth", count);
  require_length(answers, "predicted", count);
  if (heights.is_none())
    return self.add_scan(places.as_floats(), places.length(1), true_labels.as_labels(),
                         answers.as_labels());
  const PackedArray true_heights = PackedArray::floats(heights, "heights");
  require_length(true_heights, "heights", count);
  self.add_scan(places.as_floats(), places.length(1), true_labels.as_labels(), answers.as_labels(),
                true_heights.as_floats());
}

nb::object report(const SegmentationMetrics& self, bool leave_unanswered_out) {
  evaluation::Report report;
  report.unanswered = leave_unanswered_out ? Unanswered::left_out : Unanswered::as_non_ground;
  report.sequences.push_back({.name = {}, .scans = 0, .metrics = self, .median_ms = {}});
  return to_python(evaluation::to_json(report)["pooled"]);
}

nb::object to_semantic_kitti(nb::handle labels) {
  const PackedArray array = PackedArray::labels(labels, "labels");
  if (array.dimensions() != 1)
    throw nb::value_error((std::string("labels: expected one number a point, got ") +
                           description_of(array.array()).c_str())
                              .c_str());
  std::vector<std::uint32_t> classes;
  classes.reserve(array.size());
  for (const std::uint32_t label : array.as_labels()) {
    if (label > static_cast<std::uint32_t>(Label::outlier))
      throw nb::value_error(
          ("labels: expected those of Label, 0 to 3, got " + std::to_string(label)).c_str());
    classes.push_back(io::semantic_kitti_label(static_cast<Label>(label)));
  }
  const std::size_t count = classes.size();
  return to_array(std::move(classes), {count});
}

}  // namespace

void bind_segmentation_metrics(nb::module_& module) {
  nb::class_<SegmentationMetrics>(
      module, "SegmentationMetrics",
      "Scores labels as section IV of the paper does: road, parking, sidewalk, other-ground,\n"
      "lane-marking and terrain are ground; unlabeled, outlier and vegetation are ignored; the\n"
      "points of all scans are pooled.")
      .def(nb::init<>())
      .def("add_scan", &add_scan, nb::arg("points").none(), nb::arg("truth").none(),
           nb::arg("predicted").none(), nb::arg("heights") = nb::none(),
           nb::sig("def add_scan(self, points: numpy.typing.ArrayLike, truth: "
                   "numpy.typing.ArrayLike, predicted: numpy.typing.ArrayLike, heights: "
                   "numpy.typing.ArrayLike | None = None) -> None"),
           "Counts one scan.\n\n"
           "points: N × 2 or more, x, y first, metres, in the sensor's frame.\n"
           "truth: N labels of SemanticKITTI (the class in the lower 16 bits).\n"
           "predicted: N labels: 40 and the other ground classes are ground, 0 is no answer, all\n"
           "  others are non-ground. to_semantic_kitti() makes them of those of GroundGrid.\n"
           "heights: N true heights above the soil, metres, where they are known.\n\n"
           "Raises TypeError and ValueError where the arrays are of another type or length.")
      .def(
          "add",
          [](SegmentationMetrics& self, const SegmentationMetrics& other) {
            self.add(SegmentationMetrics(other));
          },
          nb::arg("other"), "Pools the points of another one with those of this one.")
      .def("report", &report, nb::kw_only(), nb::arg("leave_unanswered_out") = false,
           nb::sig("def report(self, *, leave_unanswered_out: bool = False) -> dict[str, "
                   "typing.Any]"),
           "The figures, as `groundgrid evaluate --json` has them of all points: 'points', 'tp',\n"
           "'fp', 'fn', 'tn', 'unanswered', 'precision', 'recall', 'f1', 'accuracy', 'iou' (0 to "
           "1,\n"
           "None where nothing was counted), and lists 'classes' and 'distances'. Points without "
           "an\n"
           "answer count as non-ground or, if they are left out, nowhere.");
  module.def(
      "to_semantic_kitti", &to_semantic_kitti, nb::arg("labels").none(),
      nb::sig("def to_semantic_kitti(labels: numpy.typing.ArrayLike) -> "
              "numpy.typing.NDArray[numpy.uint32]"),
      "N labels of GroundGrid as .label files have them: 40 ground, 99 obstacle, 1 outlier,\n"
      "0 unknown.");
}

}  // namespace groundgrid::python
