#include "evaluation/terrain_metrics.hpp"

#include <nanobind/stl/pair.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "array_input.hpp"
#include "bindings.hpp"
#include "evaluation/path_distance.hpp"
#include "evaluation/terrain_report.hpp"
#include "json_output.hpp"

namespace groundgrid::python {
namespace {

using evaluation::CellLattice;
using evaluation::LatticePoint;

CellLattice lattice_of(const PackedArray& layer, double resolution_m) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  if (layer.dimensions() != 2 || layer.length(0) > most || layer.length(1) > most)
    throw nb::value_error((std::string("estimated: expected rows × columns heights, got ") +
                           description_of(layer.array()).c_str())
                              .c_str());
  if (!(resolution_m > 0.0) || resolution_m > 1e6)
    throw nb::value_error("resolution_m: expected metres, more than 0 and at most 1000000");
  return {static_cast<int>(layer.length(1)), static_cast<int>(layer.length(0)), resolution_m,
          resolution_m};
}

void require_shape(const PackedArray& layer, const char* name, const CellLattice& lattice) {
  if (layer.dimensions() == 2 && layer.length(0) == static_cast<std::size_t>(lattice.rows) &&
      layer.length(1) == static_cast<std::size_t>(lattice.columns))
    return;
  throw nb::value_error((std::string(name) + ": expected the shape of estimated, (" +
                         std::to_string(lattice.rows) + ", " + std::to_string(lattice.columns) +
                         "), got " + description_of(layer.array()).c_str())
                            .c_str());
}

std::optional<PackedArray> layer_if_given(nb::handle array, const char* name,
                                          const CellLattice& lattice) {
  if (array.is_none()) return std::nullopt;
  std::optional<PackedArray> layer = PackedArray::floats(array, name);
  require_shape(*layer, name, lattice);
  return layer;
}

std::vector<float> distances_from(nb::handle path, const std::pair<double, double>& corner_m,
                                  const CellLattice& lattice) {
  if (path.is_none()) return {};
  const PackedArray places = PackedArray::floats(path, "path");
  if (places.dimensions() != 2 || places.length(1) < 2)
    throw nb::value_error("path: expected rows with x, y first");
  const std::size_t width = places.length(1);
  std::vector<LatticePoint> points;
  for (std::size_t i = 0; i < places.length(0); ++i) {
    const double x = static_cast<double>(places.as_floats()[i * width]);
    const double y = static_cast<double>(places.as_floats()[i * width + 1]);
    points.push_back({(x - corner_m.first) / lattice.cell_width_m,
                      (y - corner_m.second) / lattice.cell_height_m});
  }
  std::vector<float> distances = evaluation::path_distance(points, lattice);
  if (distances.empty()) throw nb::value_error("path: none of it lies inside of the terrain");
  return distances;
}

nb::object compare(nb::handle estimated, nb::handle reference, double resolution_m,
                   nb::handle density, nb::handle standard_deviation, nb::handle count,
                   nb::handle path, const std::pair<double, double>& corner_m,
                   const nb::dict& masks, bool solve_offset) {
  const PackedArray estimate = PackedArray::floats(estimated, "estimated");
  const CellLattice lattice = lattice_of(estimate, resolution_m);
  const PackedArray truth = PackedArray::floats(reference, "reference");
  require_shape(truth, "reference", lattice);
  const auto densities = layer_if_given(density, "density", lattice);
  const auto deviations = layer_if_given(standard_deviation, "standard_deviation", lattice);
  const auto counts = layer_if_given(count, "count", lattice);
  const std::vector<float> path_distance_m = distances_from(path, corner_m, lattice);
  evaluation::TerrainLayers layers{.lattice = lattice,
                                   .estimated_m = estimate.as_floats(),
                                   .reference_m = truth.as_floats(),
                                   .path_distance_m = path_distance_m};
  if (densities) layers.density = densities->as_floats();
  if (deviations) layers.deviation_m = deviations->as_floats();
  if (counts) layers.count = counts->as_floats();
  std::vector<PackedArray> held;
  for (const auto& [name, mask] : masks) {
    auto text = nb::cast<std::string>(nb::str(name));
    held.push_back(PackedArray::floats(mask, text.c_str()));
    require_shape(held.back(), text.c_str(), lattice);
    layers.masks.push_back({std::move(text), held.back().as_floats()});
  }
  const auto use =
      solve_offset ? evaluation::OffsetUse::taken_out : evaluation::OffsetUse::reported;
  nlohmann::ordered_json json = evaluation::to_json(
      {.lattice = lattice, .figures = evaluation::compare_terrain(layers, use)});
  for (const char* const of_files : {"map", "reference", "remarks"}) json.erase(of_files);
  return to_python(json);
}

}  // namespace

void bind_terrain_metrics(nb::module_& module) {
  module.def(
      "compare_terrain", &compare, nb::arg("estimated").none(), nb::arg("reference").none(),
      nb::arg("resolution_m"), nb::kw_only(), nb::arg("density") = nb::none(),
      nb::arg("standard_deviation") = nb::none(), nb::arg("count") = nb::none(),
      nb::arg("path") = nb::none(), nb::arg("corner_m") = std::pair<double, double>{0.0, 0.0},
      nb::arg("masks") = nb::dict(), nb::arg("solve_offset") = false,
      nb::sig("def compare_terrain(estimated: numpy.typing.ArrayLike, reference: "
              "numpy.typing.ArrayLike, resolution_m: float, *, density: numpy.typing.ArrayLike | "
              "None = None, standard_deviation: numpy.typing.ArrayLike | None = None, count: "
              "numpy.typing.ArrayLike | None = None, path: numpy.typing.ArrayLike | None = None, "
              "corner_m: tuple[float, float] = (0.0, 0.0), "
              "masks: dict[str, numpy.typing.ArrayLike] = {}, solve_offset: bool = False) -> "
              "dict[str, typing.Any]"),
      "Compares heights with those of a reference over the same square cells.\n\n"
      "estimated, reference: rows × columns heights, metres; NaN where there is none.\n"
      "density: greatest number of points per m² that one scan had around each cell.\n"
      "standard_deviation: of each estimated height, metres, as the estimate has it.\n"
      "count: number of points in each cell over the whole drive.\n"
      "path: places of the vehicle, N × 2 or more, x, y first, metres, in the frame in which the\n"
      "  outer corner of cell [0, 0] is at corner_m.\n"
      "masks: layers by name; figures of the cells that are neither 0 nor NaN in them.\n"
      "solve_offset: take the median difference in dense cells out of all figures.\n\n"
      "Returns the figures as `groundgrid evaluate-terrain --json` has them: 'all', 'density',\n"
      "'path_distance', 'slope' and 'masks', each group with 'cells', 'covered', 'coverage',\n"
      "'rmse_m', 'mae_m', 'bias_m' and 'p95_m', and 'standard_deviation', how honest these are.\n"
      "Raises TypeError and ValueError where an array is\n"
      "of another type or shape.");
}

}  // namespace groundgrid::python
