#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace groundgrid::geotiff {

/// What a drive has told about kSide × kSide cells for planners, row by row, x fastest, row 0 in
/// the south; NaN where it told nothing. Plain numbers, so that a tile goes to disk and back as its
/// bytes.
struct LayersTile {
  static constexpr int kSide = 128;
  static constexpr std::size_t kCells = std::size_t{kSide} * kSide;
  using Layer = std::array<float, kCells>;

  LayersTile() {
    for (Layer* layer : {&slope_deg, &step_m, &roughness_m, &obstacle_height_m})
      layer->fill(std::numeric_limits<float>::quiet_NaN());
  }

  Layer confidence{};  ///< Of the scan that told slope, step and roughness.
  Layer slope_deg{};
  Layer step_m{};
  Layer roughness_m{};
  Layer obstacle_height_m{};  ///< Of the last scan that told one.
};

}  // namespace groundgrid::geotiff
