#include "groundgrid/ground_grid.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "array_input.hpp"
#include "bindings.hpp"
#include "config_values.hpp"
#include "output_arrays.hpp"
#include "scan_arrays.hpp"
#include "shared_grid.hpp"
#include "terrain.hpp"

namespace groundgrid::python {
namespace {

/// ScanResult with arrays in place of spans.
struct ArrayResult {
  nb::object labels;
  nb::object height_above_ground;
  ScanResult result;
};

ArrayResult process_scans(SharedGrid& self, const std::vector<ScanArguments>& arguments,
                          nb::handle pose, nb::handle pose_begin, nb::handle out) {
  const ScanArrays scans(arguments);
  if (pose_begin.is_none() && scans.have_times())
    throw nb::value_error("times: expected together with pose_begin, the pose at their begin");
  Poses poses{std::nullopt, transform_from(pose, "pose")};
  if (!pose_begin.is_none()) poses.begin = transform_from(pose_begin, "pose_begin");
  const OutputArrays output(out, scans);
  ScanResult result = self.process(scans, poses, output.spans());
  result.labels = {};
  result.height_above_ground = {};
  return {output.labels(), output.heights(), result};
}

ArrayResult process_scan(SharedGrid& self, nb::object points, nb::handle pose, nb::object mounting,
                         nb::object times, nb::object time_span, nb::handle pose_begin,
                         nb::handle out) {
  return process_scans(
      self, {{std::move(points), std::move(mounting), std::move(times), std::move(time_span)}},
      pose, pose_begin, out);
}

std::optional<double> estimate_height(nb::handle points, const Config& config) {
  const PointArray array(points);
  const nb::gil_scoped_release no_gil;
  std::vector<std::byte> copy;
  return estimate_sensor_height(array.view(copy), config);
}

std::string repr_of_result(const ArrayResult& self) {
  return "ScanResult(ground=" + std::to_string(self.result.ground) +
         ", obstacle=" + std::to_string(self.result.obstacle) +
         ", outlier=" + std::to_string(self.result.outlier) +
         ", unknown=" + std::to_string(self.result.unknown) + ")";
}

int threads_from(nb::handle value) {
  int threads = 0;
  if (PyBool_Check(value.ptr()) || !PyIndex_Check(value.ptr()) ||
      !nb::try_cast(nb::steal<nb::object>(PyNumber_Index(value.ptr())), threads))
    throw nb::type_error(
        (std::string("threads: expected int, got ") + nb::type_name(value.type()).c_str()).c_str());
  return threads;
}

template <auto Member>
auto of_result(const ArrayResult& self) {
  return self.result.*Member;
}

void bind_sensor_scan(nb::module_& module) {
  nb::class_<ScanArguments>(
      module, "SensorScan",
      "The points that one sensor delivered in one scan, for GroundGrid.process_scans(). It holds\n"
      "the arrays themselves, not copies.")
      .def(nb::init<nb::object, nb::object, nb::object, nb::object>(), nb::arg("points"),
           nb::arg("mounting") = nb::none(), nb::kw_only(), nb::arg("times") = nb::none(),
           nb::arg("time_span") = nb::none(),
           nb::sig("def __init__(self, points: numpy.typing.ArrayLike, mounting: "
                   "numpy.typing.ArrayLike | None = None, *, times: numpy.typing.ArrayLike | None "
                   "= None, time_span: tuple[float, float] | None = None) -> None"),
           "As the arguments of GroundGrid.process().");
}

void bind_result(nb::module_& module) {
  nb::class_<ArrayResult>(
      module, "ScanResult",
      "The result of process(). Element i belongs to input point i; with several sensors the "
      "points\n"
      "of the first scan come first. `labels, heights = grid.process(points, pose)` unpacks it.")
      .def_ro("labels", &ArrayResult::labels,
              nb::for_getter(nb::sig("def labels(self) -> numpy.typing.NDArray[numpy.uint8]")),
              "N numbers of Label, uint8.")
      .def_ro(
          "height_above_ground", &ArrayResult::height_above_ground,
          nb::for_getter(
              nb::sig("def height_above_ground(self) -> numpy.typing.NDArray[numpy.float32]")),
          "N heights in metres above the ground at each point, by which its label was chosen: the\n"
          "mean of the ground returns around; NaN if the label is unknown. float32.")
      .def_prop_ro("ground", &of_result<&ScanResult::ground>, "Number of points on the ground.")
      .def_prop_ro("obstacle", &of_result<&ScanResult::obstacle>, "Number of points above it.")
      .def_prop_ro("outlier", &of_result<&ScanResult::outlier>, "Number of reflections below it.")
      .def_prop_ro("unknown", &of_result<&ScanResult::unknown>, "Number of points without a label.")
      .def_prop_ro(
          "sensor_height_m", &of_result<&ScanResult::sensor_height_m>,
          "Height of the first sensor above the ground in use, metres; None where none is\n"
          "given and no scan so far showed the ground.")
      .def_prop_ro("sensor_height_estimated", &of_result<&ScanResult::sensor_height_estimated>,
                   "Whether that height was estimated from a scan and not given.")
      .def_prop_ro("map_restarted", &of_result<&ScanResult::map_restarted>,
                   "Whether the pose jumped by more than 20 m, so that the map was started anew.")
      .def(
          "__iter__",
          [](const ArrayResult& self) {
            return nb::iter(nb::make_tuple(self.labels, self.height_above_ground));
          },
          nb::sig("def __iter__(self) -> collections.abc.Iterator[numpy.typing.NDArray"
                  "[typing.Any]]"))
      .def("__repr__", &repr_of_result);
}

void bind_grid(nb::module_& module) {
  nb::class_<SharedGrid> grid(
      module, "GroundGrid",
      "Ground segmentation and terrain estimation for one vehicle: GroundGrid (Steinke, Goehring,\n"
      "Rojas, RA-L 2024). Scans and poses go in; labels come out and a rolling map stays.\n\n"
      "Frames: base is the vehicle's, on the ground below it, x forward, z up; map has z against\n"
      "gravity. Labels and terrain are the same bits for any number of threads and any order of\n"
      "the points. Other Python threads run while it works; calls of one object take turns.");
  const std::string init = "def __init__(self, config: Config | None = None" +
                           keyword_signature(false) + ", threads: int = 1) -> None";
  grid.def(
      "__init__",
      [](SharedGrid* self, const std::optional<Config>& config, const nb::kwargs& values) {
        nb::dict others;
        int threads = 1;
        for (const auto& [name, value] : values) {
          if (nb::cast<std::string>(name) == "threads")
            threads = threads_from(value);
          else
            others[name] = value;
        }
        new (self) SharedGrid(with_values(config.value_or(Config{}), others), threads);
      },
      nb::arg("config") = nb::none(), nb::arg("values"), nb::sig(init.c_str()),
      "With this configuration, the default if it is left out, but for the parameters that are\n"
      "given by keyword. threads: 0 is one per core. Raises ValueError, with the name, if one is\n"
      "out of range.");
  grid.def(
      "process", &process_scan, nb::arg("points").none(), nb::arg("pose") = nb::none(),
      nb::kw_only(), nb::arg("mounting") = nb::none(), nb::arg("times") = nb::none(),
      nb::arg("time_span") = nb::none(), nb::arg("pose_begin") = nb::none(),
      nb::arg("out") = nb::none(),
      nb::sig("def process(self, points: numpy.typing.ArrayLike, pose: numpy.typing.ArrayLike | "
              "None = None, *, mounting: numpy.typing.ArrayLike | None = None, times: "
              "numpy.typing.ArrayLike | None = None, time_span: tuple[float, float] | None = None, "
              "pose_begin: numpy.typing.ArrayLike | None = None, out: tuple[numpy.typing.NDArray"
              "[numpy.uint8], numpy.typing.NDArray[numpy.float32]] | None = None) -> ScanResult"),
      "Takes one scan.\n\n"
      "points: N × 3 or more, float32 or float64, x, y, z first, metres, in the sensor's frame.\n"
      "  float32 is read where it lies if each point's numbers lie behind those of the point\n"
      "  before; other arrays are copied. NaN, infinite and (0, 0, 0) points become unknown.\n"
      "pose: T_map_base, 4 × 4 or 3 × 4, metres; the identity where it is left out.\n"
      "mounting: T_base_sensor, the same; left out, the points are in base itself and the ground\n"
      "  lies Config.vehicle.sensor_height_m below it, or where the first scan shows it.\n"
      "times, time_span, pose_begin: for scans that are not motion-corrected, the time of each\n"
      "  point (N, float32, float64 or uint32), those of begin and end of the scan in the same\n"
      "  unit, and the pose at its begin; `pose` is then the one at its end.\n"
      "out: (labels, heights), uint8 and float32 of N elements, to be written into instead of "
      "into\n"
      "  new arrays.\n\n"
      "Raises TypeError and ValueError, with the map untouched, where an array has another type "
      "or\n"
      "shape, a transform is not rigid, or there are more than 4194304 points.");
  grid.def(
      "process_scans", &process_scans, nb::arg("scans"), nb::arg("pose") = nb::none(),
      nb::kw_only(), nb::arg("pose_begin") = nb::none(), nb::arg("out") = nb::none(),
      nb::sig("def process_scans(self, scans: collections.abc.Sequence[SensorScan], pose: "
              "numpy.typing.ArrayLike | None = None, *, pose_begin: numpy.typing.ArrayLike | None "
              "= None, out: tuple[numpy.typing.NDArray[numpy.uint8], numpy.typing.NDArray"
              "[numpy.float32]] | None = None) -> ScanResult"),
      "Takes the scans of several sensors at one pose: process() with more than one scan.");
  grid.def("reset", &SharedGrid::reset,
           "Forgets the map, its lattice's anchor and the estimated sensor height.");
  grid.def_prop_ro(
      "terrain",
      [](SharedGrid& self) {
        return Terrain(self.visit([](const GroundGrid& map) {
          return TerrainCopy(map.terrain(), map.standard_deviation());
        }));
      },
      "A copy of the map as it stands after the last scan.");
  grid.def_prop_ro(
      "config", [](const SharedGrid& self) { return Config(self.config()); },
      "A copy of the configuration.");
}

}  // namespace

void bind_ground_grid(nb::module_& module) {
  bind_sensor_scan(module);
  bind_result(module);
  bind_grid(module);
  module.def(
      "estimate_sensor_height", &estimate_height, nb::arg("points").none(),
      nb::arg("config") = Config{},
      nb::sig("def estimate_sensor_height(points: numpy.typing.ArrayLike, config: Config = "
              "...) -> float | None"),
      "Height in metres of a roughly level sensor above the ground around it, from one scan\n"
      "in its frame (N × 3 or more, float32 or float64); None where it shows no flat ground\n"
      "up to 8 m below.");
}

}  // namespace groundgrid::python
