#include "terrain.hpp"

#include <utility>

#include "array_output.hpp"
#include "bindings.hpp"

namespace groundgrid::python {
namespace {

/// Middles of so many cells in a row.
std::vector<double> middles(int cells, double min, double cell_size) {
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(cells));
  for (int i = 0; i < cells; ++i) places.push_back(min + (i + 0.5) * cell_size);
  return places;
}

nb::object x_of(const Terrain& terrain) {
  return to_array(middles(terrain.size, terrain.min_x_m, terrain.resolution_m),
                  {static_cast<std::size_t>(terrain.size)});
}

nb::object y_of(const Terrain& terrain) {
  return to_array(middles(terrain.size, terrain.min_y_m, terrain.resolution_m),
                  {static_cast<std::size_t>(terrain.size)});
}

nb::tuple extent_of(const Terrain& terrain) {
  const double side = terrain.size * terrain.resolution_m;
  return nb::make_tuple(terrain.min_x_m, terrain.min_x_m + side, terrain.min_y_m,
                        terrain.min_y_m + side);
}

}  // namespace

TerrainCopy::TerrainCopy(const TerrainView& view, std::span<const float> standard_deviation_m)
    : size(view.size),
      resolution_m(view.resolution_m),
      min_x_m(view.min_x_m),
      min_y_m(view.min_y_m),
      standard_deviation(standard_deviation_m.begin(), standard_deviation_m.end()),
      confidence(view.confidence.begin(), view.confidence.end()) {
  const std::size_t cells = confidence.size();
  height.reserve(cells);
  variance.reserve(cells);
  lowest.reserve(cells);
  highest.reserve(cells);
  points.reserve(cells);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const TerrainCell cell = view.cell(column, row);
      height.push_back(cell.height);
      variance.push_back(cell.variance);
      lowest.push_back(cell.lowest);
      highest.push_back(cell.highest);
      points.push_back(cell.points);
    }
}

Terrain::Terrain(TerrainCopy layers)
    : size(layers.size),
      resolution_m(layers.resolution_m),
      min_x_m(layers.min_x_m),
      min_y_m(layers.min_y_m) {
  const auto side = static_cast<std::size_t>(size);
  height = to_array(std::move(layers.height), {side, side});
  standard_deviation = to_array(std::move(layers.standard_deviation), {side, side});
  confidence = to_array(std::move(layers.confidence), {side, side});
  variance = to_array(std::move(layers.variance), {side, side});
  lowest = to_array(std::move(layers.lowest), {side, side});
  highest = to_array(std::move(layers.highest), {side, side});
  points = to_array(std::move(layers.points), {side, side});
}

void bind_terrain(nb::module_& module) {
  nb::class_<Terrain>(
      module, "Terrain",
      "The map after a scan: square cells around the vehicle, in the map frame, and what is known\n"
      "of each. Layers have the shape (size, size) and are indexed [row, column]: rows along y,\n"
      "columns along x. They are copies, which no later scan changes. Size 0 before the first.")
      .def_ro("size", &Terrain::size, "Cells along x and along y.")
      .def_ro("resolution_m", &Terrain::resolution_m, "Length of a cell's side, metres.")
      .def_ro("min_x_m", &Terrain::min_x_m, "Map frame x of the outer edge of column 0, metres.")
      .def_ro("min_y_m", &Terrain::min_y_m, "Map frame y of the outer edge of row 0, metres.")
      .def_prop_ro("x_m", &x_of, nb::sig("def x_m(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "Map frame x of the middle of each column, metres.")
      .def_prop_ro("y_m", &y_of, nb::sig("def y_m(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "Map frame y of the middle of each row, metres.")
      .def_prop_ro("extent_m", &extent_of,
                   nb::sig("def extent_m(self) -> tuple[float, float, float, float]"),
                   "Least and greatest x, least and greatest y, metres: `extent` of matplotlib's\n"
                   "imshow(..., origin='lower').")
      .def_ro("height", &Terrain::height,
              nb::for_getter(nb::sig("def height(self) -> numpy.typing.NDArray[numpy.float64]")),
              "Estimated height of the ground in the map frame, metres.")
      .def_ro("standard_deviation", &Terrain::standard_deviation,
              nb::for_getter(
                  nb::sig("def standard_deviation(self) -> numpy.typing.NDArray[numpy.float32]")),
              "One standard deviation of the height, metres.")
      .def_ro(
          "confidence", &Terrain::confidence,
          nb::for_getter(nb::sig("def confidence(self) -> numpy.typing.NDArray[numpy.float32]")),
          "0 (never seen, extrapolated) to 1.")
      .def_ro("variance", &Terrain::variance,
              nb::for_getter(nb::sig("def variance(self) -> numpy.typing.NDArray[numpy.float32]")),
              "Variance of z of the last scan's points in the cell, m²; NaN where it had none.")
      .def_ro("lowest", &Terrain::lowest,
              nb::for_getter(nb::sig("def lowest(self) -> numpy.typing.NDArray[numpy.float64]")),
              "Lowest point of the last scan, map frame, metres; NaN where it had none.")
      .def_ro("highest", &Terrain::highest,
              nb::for_getter(nb::sig("def highest(self) -> numpy.typing.NDArray[numpy.float64]")),
              "Highest point of the last scan, map frame, metres; NaN where it had none.")
      .def_ro("points", &Terrain::points,
              nb::for_getter(nb::sig("def points(self) -> numpy.typing.NDArray[numpy.uint32]")),
              "Number of points of the last scan in the cell.");
}

}  // namespace groundgrid::python
