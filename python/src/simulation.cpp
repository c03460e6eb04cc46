#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "array_output.hpp"
#include "bindings.hpp"
#include "simulation/sensor_file.hpp"
#include "simulation/simulated_drive.hpp"
#include "simulation/truth_rasters.hpp"

namespace groundgrid::python {
namespace {

using simulation::DriveOptions;
using simulation::Motion;
using simulation::Sensor;
using simulation::SimulatedDrive;

constexpr std::size_t kMaxScans = 100000;

/// A scan as Python has it.
struct ScanWithTruth {
  nb::object points;
  nb::object labels;
  nb::object heights;
  nb::object pose;
  double time_s;
};

/// What is true of the ground of a drive.
struct TrueTerrain {
  geotiff::RasterGrid grid;
  nb::object height;
  nb::object vegetation;
  nb::object kerbs;
};

struct TrueLayers {
  geotiff::RasterGrid grid;
  std::vector<float> height;
  std::vector<float> vegetation;
  std::vector<float> kerbs;
};

/// A drive whose callers take turns. Its map frame has its origin where the sensor is at first.
class SharedDrive {
 public:
  explicit SharedDrive(DriveOptions options)
      : drive_(std::move(options)), scanner_(drive_.scanner(0)) {
    const Eigen::Vector3d first = drive_.pose(0, 0).translation();
    T_map_world_ = Eigen::Translation3d(-first);
    simulation::PoseErrors errors = drive_.pose_errors(0);
    for (std::size_t i = 0; i < scans(); ++i) {
      const Eigen::Isometry3d truth = drive_.pose(0, i);
      true_poses_.push_back(T_map_world_ * truth);
      poses_.push_back(T_map_world_ * errors.estimate(truth));
    }
  }

  [[nodiscard]] std::size_t scans() const { return drive_.options().scans; }
  [[nodiscard]] const Sensor& sensor() const { return drive_.options().sensors.front(); }
  [[nodiscard]] const std::vector<Eigen::Isometry3d>& true_poses() const { return true_poses_; }
  [[nodiscard]] const std::vector<Eigen::Isometry3d>& poses() const { return poses_; }
  [[nodiscard]] double time_s(std::size_t scan) const { return drive_.time_s(0, scan); }

  simulation::Scan scan(std::size_t index) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return scanner_.scan(index);
  }

  TrueLayers terrain() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    const geotiff::RasterGrid grid = simulation::grid_around(true_poses_);
    const simulation::TruthRasters rasters(
        drive_.world(), grid, T_map_world_.inverse() * Eigen::Vector3d::Zero(), drive_.runner());
    return {grid, rasters.heights(), rasters.under_leaves(), rasters.at_kerbs()};
  }

 private:
  std::mutex mutex_;
  SimulatedDrive drive_;
  simulation::Scanner scanner_;
  Eigen::Isometry3d T_map_world_;
  std::vector<Eigen::Isometry3d> true_poses_;
  std::vector<Eigen::Isometry3d> poses_;
};

Sensor sensor_named(const std::string& name) {
  const std::vector<std::string> names = simulation::sensor_names();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return simulation::make_sensor(name);
  if (name.ends_with(".toml")) return simulation::read_sensor(name);
  std::string known;
  for (const std::string& each : names) known += each + ", ";
  throw nb::value_error(
      ("sensor: expected " + known + "or a file that ends with .toml, got '" + name + "'").c_str());
}

Motion motion_named(const std::string& name) {
  if (name == "corrected") return Motion::corrected;
  if (name == "distorted") return Motion::distorted;
  throw nb::value_error(
      ("motion: expected 'corrected' or 'distorted', got '" + name + "'").c_str());
}

void require(bool holds, const char* message) {
  if (!holds) throw nb::value_error(message);
}

DriveOptions options_of(const std::string& scene, const std::string& sensor, std::int64_t scans,
                        std::uint64_t seed, std::optional<double> sensor_height_m,
                        const std::string& motion, double pose_noise_m, double pose_drift_m,
                        int threads) {
  require(scans >= 1 && scans <= static_cast<std::int64_t>(kMaxScans),
          "scans: expected 1 to 100000");
  require(threads >= 0 && threads <= 1024, "threads: expected 0 to 1024");
  require(pose_noise_m >= 0.0 && pose_noise_m <= 10.0, "pose_noise_m: expected 0 to 10");
  require(pose_drift_m >= 0.0 && pose_drift_m <= 1.0, "pose_drift_m: expected 0 to 1");
  require(!sensor_height_m || (*sensor_height_m >= 0.2 && *sensor_height_m <= 5.0),
          "sensor_height_m: expected 0.2 to 5");
  DriveOptions options{.scene = scene,
                       .sensors = {sensor_named(sensor)},
                       .scans = static_cast<std::size_t>(scans),
                       .seed = seed,
                       .motion = motion_named(motion),
                       .threads = threads,
                       .pose_noise_m = pose_noise_m,
                       .pose_drift_m = pose_drift_m};
  if (sensor_height_m) options.sensors.front().mount.height_m = *sensor_height_m;
  return options;
}

void make_drive(SharedDrive* self, const std::string& scene, const std::string& sensor,
                std::int64_t scans, std::uint64_t seed, std::optional<double> sensor_height_m,
                const std::string& motion, double pose_noise_m, double pose_drift_m, int threads) {
  DriveOptions options = options_of(scene, sensor, scans, seed, sensor_height_m, motion,
                                    pose_noise_m, pose_drift_m, threads);
  const nb::gil_scoped_release no_gil;
  new (self) SharedDrive(std::move(options));
}

ScanWithTruth scan_at(SharedDrive& self, std::int64_t index) {
  const auto scans = static_cast<std::int64_t>(self.scans());
  const std::int64_t place = index < 0 ? index + scans : index;
  if (place < 0 || place >= scans)
    throw nb::index_error(("the drive has " + std::to_string(scans) + " scans").c_str());
  const auto number = static_cast<std::size_t>(place);
  simulation::Scan scan = self.scan(number);
  const std::size_t points = scan.labels.size();
  return {to_array(std::move(scan.points), {points, 4}), to_array(std::move(scan.labels), {points}),
          to_array(std::move(scan.heights), {points}), to_array(self.true_poses()[number]),
          self.time_s(number)};
}

TrueTerrain terrain_of(SharedDrive& self) {
  TrueLayers layers = self.terrain();
  const auto rows = static_cast<std::size_t>(layers.grid.rows);
  const auto columns = static_cast<std::size_t>(layers.grid.columns);
  return {layers.grid, to_array(std::move(layers.height), {rows, columns}),
          to_array(std::move(layers.vegetation), {rows, columns}),
          to_array(std::move(layers.kerbs), {rows, columns})};
}

nb::for_getter<nb::sig> array_of_float32(const char* signature) { return {nb::sig(signature)}; }

void bind_scan(nb::module_& module) {
  nb::class_<ScanWithTruth>(module, "SimulatedScan",
                            "One simulated scan, with all that is true of it.")
      .def_ro("points", &ScanWithTruth::points,
              array_of_float32("def points(self) -> numpy.typing.NDArray[numpy.float32]"),
              "N × 4 float32: x, y, z in metres in the sensor's frame, intensity from 0 to 1.")
      .def_ro("labels", &ScanWithTruth::labels,
              nb::for_getter(nb::sig("def labels(self) -> numpy.typing.NDArray[numpy.uint32]")),
              "N uint32: SemanticKITTI class, and the instance in the upper 16 bits.")
      .def_ro("heights", &ScanWithTruth::heights,
              array_of_float32("def heights(self) -> numpy.typing.NDArray[numpy.float32]"),
              "N float32: metres above the soil.")
      .def_ro("pose", &ScanWithTruth::pose,
              nb::for_getter(nb::sig("def pose(self) -> numpy.typing.NDArray[numpy.float64]")),
              "The true T_map_sensor in the middle of the scan, 4 × 4 float64.")
      .def_ro("time_s", &ScanWithTruth::time_s, "Seconds after the first scan.");
}

void bind_true_terrain(nb::module_& module) {
  nb::class_<TrueTerrain>(
      module, "TrueTerrain",
      "What is true of the ground up to 80 m around a drive, in square cells. Layers are indexed\n"
      "[row, column]: rows along y, columns along x of the drive's map frame.")
      .def_prop_ro(
          "resolution_m", [](const TrueTerrain& self) { return self.grid.resolution_m; },
          "Length of a cell's side, metres.")
      .def_prop_ro(
          "min_x_m", [](const TrueTerrain& self) { return self.grid.min_x_m; },
          "x of the outer edge of column 0, metres.")
      .def_prop_ro(
          "min_y_m", [](const TrueTerrain& self) { return self.grid.min_y_m; },
          "y of the outer edge of row 0, metres.")
      .def_ro("height", &TrueTerrain::height,
              array_of_float32("def height(self) -> numpy.typing.NDArray[numpy.float32]"),
              "Of the soil in the middle of each cell, metres.")
      .def_ro("vegetation", &TrueTerrain::vegetation,
              array_of_float32("def vegetation(self) -> numpy.typing.NDArray[numpy.float32]"),
              "1 where leaves are above, else 0.")
      .def_ro("kerbs", &TrueTerrain::kerbs,
              array_of_float32("def kerbs(self) -> numpy.typing.NDArray[numpy.float32]"),
              "1 within 0.3 m of a kerb or step, else 0.");
}

void bind_drive(nb::module_& module) {
  nb::class_<SharedDrive>(
      module, "Drive",
      "A simulated drive with exact labels, heights and terrain. `for scan in drive` gives its\n"
      "scans, drive[i] one of them. The map frame has its origin where the sensor is at first, z "
      "up\n"
      "and x along the vehicle.")
      .def("__init__", &make_drive, nb::arg("scene") = "urban", nb::arg("sensor") = "hdl-64e",
           nb::kw_only(), nb::arg("scans") = 200, nb::arg("seed") = 1,
           nb::arg("sensor_height_m") = nb::none(), nb::arg("motion") = "corrected",
           nb::arg("pose_noise_m") = 0.0, nb::arg("pose_drift_m") = 0.0, nb::arg("threads") = 0,
           "scene: one of scene_names().\n"
           "sensor: one of sensor_names(), or a .toml file that describes one.\n"
           "scans: how many, 1 to 100000.\n"
           "seed: of the world and all noise.\n"
           "sensor_height_m: over the ground, instead of the sensor's usual height.\n"
           "motion: 'corrected' puts all points into the frame of the scan's middle, 'distorted'\n"
           "  leaves them as the moving sensor saw them.\n"
           "pose_noise_m, pose_drift_m: standard deviations of the error of each of `poses` but "
           "the\n"
           "  first, and of what adds up over a metre driven.\n"
           "threads: 0 for one a core; changes no bit.\n\n"
           "Raises ValueError where there is no such scene or sensor, or a value is out of range.")
      .def("__len__", &SharedDrive::scans)
      .def("__getitem__", &scan_at, nb::arg("index"), "Simulates one scan. Raises IndexError.")
      .def(
          "__iter__",
          [](nb::handle self) {
            nb::object iterator = nb::steal(PySeqIter_New(self.ptr()));
            if (!iterator.is_valid()) throw nb::python_error();
            return iterator;
          },
          nb::sig("def __iter__(self) -> collections.abc.Iterator[SimulatedScan]"))
      .def_prop_ro(
          "poses", [](const SharedDrive& self) { return to_array(std::span(self.poses())); },
          nb::sig("def poses(self) -> numpy.typing.NDArray[numpy.float64]"),
          "T_map_sensor at each scan as a localisation with these errors has it, N × 4 × 4.")
      .def_prop_ro(
          "true_poses",
          [](const SharedDrive& self) { return to_array(std::span(self.true_poses())); },
          nb::sig("def true_poses(self) -> numpy.typing.NDArray[numpy.float64]"),
          "T_map_sensor at each scan, N × 4 × 4.")
      .def_prop_ro(
          "sensor_height_m", [](const SharedDrive& self) { return self.sensor().mount.height_m; },
          "Height of the sensor above the ground, metres.")
      .def_prop_ro(
          "T_base_sensor",
          [](const SharedDrive& self) { return to_array(self.sensor().T_base_sensor()); },
          nb::sig("def T_base_sensor(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Where the sensor sits on the vehicle, 4 × 4.")
      .def_prop_ro("terrain", &terrain_of, "The true terrain, computed anew at each access.");
}

}  // namespace

void bind_simulation(nb::module_& module) {
  bind_scan(module);
  bind_true_terrain(module);
  bind_drive(module);
  module.def("scene_names", &simulation::scene_names, "The scenes that Drive knows.");
  module.def("sensor_names", &simulation::sensor_names, "The sensors that Drive knows.");
}

}  // namespace groundgrid::python
