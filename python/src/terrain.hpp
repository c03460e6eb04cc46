#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "groundgrid/terrain_view.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// The layers of a map at one moment. Taken without the GIL.
struct TerrainCopy {
  TerrainCopy(const TerrainView& view, std::span<const float> standard_deviation_m);

  int size;
  double resolution_m;
  double min_x_m;
  double min_y_m;
  std::vector<double> height;
  std::vector<float> standard_deviation;
  std::vector<float> confidence;
  std::vector<float> variance;
  std::vector<double> lowest;
  std::vector<double> highest;
  std::vector<std::uint32_t> points;
};

/// The same as Python has it: arrays that nothing else writes to.
struct Terrain {
  explicit Terrain(TerrainCopy layers);

  int size;
  double resolution_m;
  double min_x_m;
  double min_y_m;
  nb::object height;
  nb::object standard_deviation;
  nb::object confidence;
  nb::object variance;
  nb::object lowest;
  nb::object highest;
  nb::object points;
};

}  // namespace groundgrid::python
