#include "groundgrid/terrain_layers.hpp"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "array_input.hpp"
#include "array_output.hpp"
#include "bindings.hpp"
#include "scan_arrays.hpp"
#include "shared_grid.hpp"

namespace groundgrid::python {
namespace {

/// The labels of a scan, from numbers of Label.
std::vector<Label> labels_from(nb::handle array) {
  const PackedArray numbers = PackedArray::labels(array, "labels");
  std::vector<Label> labels;
  labels.reserve(numbers.size());
  for (const std::uint32_t number : numbers.as_labels()) {
    if (number > static_cast<std::uint32_t>(Label::outlier))
      throw nb::value_error(
          ("labels: expected those of Label, 0 to 3, got " + std::to_string(number)).c_str());
    labels.push_back(static_cast<Label>(number));
  }
  return labels;
}

/// The layers of a map, whose callers take turns.
class SharedLayers {
 public:
  explicit SharedLayers(double window_m) : layers_(window_m) {}

  /// `write` gets the layers and the map; it runs without the GIL.
  template <typename Write>
  void update(SharedGrid& grid, const Write& write) {
    grid.visit([&](const GroundGrid& map) {
      const std::lock_guard turn(mutex_);
      write(layers_, map);
      return true;
    });
  }

  /// What `read` makes of the layers as they stand; it runs without the GIL.
  template <typename Read>
  auto visit(const Read& read) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return read(layers_);
  }

 private:
  std::mutex mutex_;
  TerrainLayers layers_;
};

void update_from_map(SharedLayers& self, SharedGrid& grid, const TraversabilityLimits& limits) {
  self.update(grid, [&](TerrainLayers& layers, const GroundGrid& map) {
    layers.update(map.terrain(), limits);
  });
}

void update(SharedLayers& self, SharedGrid& grid, nb::object points, nb::handle pose,
            nb::handle labels, nb::object mounting, const TraversabilityLimits& limits) {
  if (points.is_none() != labels.is_none())
    throw nb::value_error("points and labels: expected both or neither");
  if (points.is_none()) return update_from_map(self, grid, limits);
  const ScanArrays scans({{std::move(points), std::move(mounting), nb::none(), nb::none()}});
  const std::vector<Label> answers = labels_from(labels);
  const Eigen::Isometry3d T_map_base = transform_from(pose, "pose");
  self.update(grid, [&](TerrainLayers& layers, const GroundGrid& map) {
    std::vector<std::vector<std::byte>> copies;
    layers.update(map.terrain(), scans.views(copies), T_map_base, answers, limits);
  });
}

int size_of(SharedLayers& self) {
  return self.visit([](const TerrainLayers& layers) { return layers.size(); });
}

/// One layer as it stood at one moment, and cells along each side.
template <typename Number>
struct LayerCopy {
  std::size_t side;
  std::vector<Number> cells;
};

template <typename Number>
nb::object to_square(LayerCopy<Number> layer) {
  return to_array(std::move(layer.cells), {layer.side, layer.side});
}

nb::object traversability(SharedLayers& self) {
  return to_square(self.visit([](const TerrainLayers& layers) {
    LayerCopy<std::uint8_t> copy{static_cast<std::size_t>(layers.size()), {}};
    for (const Traversability each : layers.traversability())
      copy.cells.push_back(static_cast<std::uint8_t>(each));
    return copy;
  }));
}

template <auto Layer>
nb::object float_layer(SharedLayers& self) {
  return to_square(self.visit([](const TerrainLayers& layers) {
    const std::span<const float> cells = (layers.*Layer)();
    return LayerCopy<float>{static_cast<std::size_t>(layers.size()), {cells.begin(), cells.end()}};
  }));
}

void bind_limits(nb::module_& module) {
  const TraversabilityLimits defaults;
  nb::class_<TraversabilityLimits>(
      module, "TraversabilityLimits",
      "Up to where a vehicle drives; the defaults are those of a car. Raises ValueError, with the\n"
      "name, where one is negative or not finite.")
      .def(
          "__init__",
          [](TraversabilityLimits* self, double slope, double step, double roughness,
             double obstacle, double overhang, double confidence) {
            const TraversabilityLimits limits{slope,    step,     roughness,
                                              obstacle, overhang, confidence};
            limits.validate();
            new (self) TraversabilityLimits(limits);
          },
          nb::kw_only(), nb::arg("max_slope_deg") = defaults.max_slope_deg,
          nb::arg("max_step_m") = defaults.max_step_m,
          nb::arg("max_roughness_m") = defaults.max_roughness_m,
          nb::arg("min_obstacle_height_m") = defaults.min_obstacle_height_m,
          nb::arg("overhang_clearance_m") = defaults.overhang_clearance_m,
          nb::arg("min_confidence") = defaults.min_confidence)
      .def_ro("max_slope_deg", &TraversabilityLimits::max_slope_deg, "Steepest slope.")
      .def_ro("max_step_m", &TraversabilityLimits::max_step_m, "Highest step.")
      .def_ro("max_roughness_m", &TraversabilityLimits::max_roughness_m, "Greatest roughness.")
      .def_ro("min_obstacle_height_m", &TraversabilityLimits::min_obstacle_height_m,
              "Lower returns above the ground are no obstacle.")
      .def_ro("overhang_clearance_m", &TraversabilityLimits::overhang_clearance_m,
              "Higher returns above the ground are driven under.")
      .def_ro("min_confidence", &TraversabilityLimits::min_confidence,
              "Cells of the map with less are not known.");
}

void bind_traversability(nb::module_& module) {
  nb::enum_<Traversability>(module, "Traversability", nb::is_arithmetic(),
                            "Whether a vehicle can drive over a cell. An IntEnum, to compare "
                            "TerrainLayers.traversability with.")
      .value("UNKNOWN", Traversability::unknown, "Slope, step or roughness is not known.")
      .value("NO", Traversability::no, "An obstacle stands there, or a limit is passed.")
      .value("YES", Traversability::yes, "No obstacle, and all limits are kept.");
}

}  // namespace

void bind_terrain_layers(nb::module_& module) {
  bind_traversability(module);
  bind_limits(module);
  const char* const array = "numpy.typing.NDArray[numpy.float32]";
  const auto getter = [&](const char* name) {
    return std::string("def ") + name + "(self) -> " + array;
  };
  nb::class_<SharedLayers> layers(
      module, "TerrainLayers",
      "What planners ask of the map beyond its height: slope, step, roughness, obstacles, and\n"
      "whether a cell can be driven over. Layers have the shape and order of those of Terrain and\n"
      "are copies. Only cells whose confidence reaches TraversabilityLimits.min_confidence count.");
  layers.def(nb::init<double>(), nb::arg("window_m") = 1.0,
             "Planes are fitted to squares of an odd number of cells, whose side is nearest to\n"
             "window_m, metres, and at least three cells. Raises ValueError where it is not in\n"
             "(0, 100].");
  layers.def(
      "update", &update, nb::arg("grid"), nb::arg("points") = nb::none(),
      nb::arg("pose") = nb::none(), nb::arg("labels") = nb::none(), nb::kw_only(),
      nb::arg("mounting") = nb::none(), nb::arg("limits") = TraversabilityLimits{},
      nb::sig("def update(self, grid: GroundGrid, points: numpy.typing.ArrayLike | None = None, "
              "pose: numpy.typing.ArrayLike | None = None, labels: numpy.typing.ArrayLike | None = "
              "None, *, mounting: numpy.typing.ArrayLike | None = None, limits: "
              "TraversabilityLimits = ...) -> None"),
      "Makes all layers anew from the grid's map. points, pose and mounting are those that\n"
      "GroundGrid.process() got last and labels those that it gave; without them obstacles are\n"
      "told from the least and greatest height of each cell alone. Raises ValueError where there\n"
      "is not one label a point.");
  layers.def_prop_ro("size", &size_of, "Cells along x and y; 0 before update().");
  const auto add = [&](const char* name, auto read, const char* doc) {
    layers.def_prop_ro(name, read, nb::for_getter(nb::sig(getter(name).c_str())), doc);
  };
  add("slope_deg", &float_layer<&TerrainLayers::slope_deg>,
      "Angle of the plane through the window to the horizontal, degrees; NaN where less than\n"
      "half of the window is known.");
  add("step_m", &float_layer<&TerrainLayers::step_m>,
      "Greatest rise from one neighbour to the opposite one beyond the slope of the ground on\n"
      "both sides, metres; NaN where no two opposite neighbours are known.");
  add("roughness_m", &float_layer<&TerrainLayers::roughness_m>,
      "Root mean square of the window's heights from its plane, metres; NaN as the slope.");
  add("obstacle_height_m", &float_layer<&TerrainLayers::obstacle_height_m>,
      "Height above the map of the highest return of the last scan below the clearance, metres;\n"
      "0 where it is lower than min_obstacle_height_m, NaN where none was below the clearance.");
  layers.def_prop_ro(
      "traversability", &traversability,
      nb::for_getter(nb::sig("def traversability(self) -> numpy.typing.NDArray[numpy.uint8]")),
      "Numbers of Traversability, uint8.");
}

}  // namespace groundgrid::python
