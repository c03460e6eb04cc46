#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rendering/scan_picture.hpp"

namespace groundgrid::program {

/// The groups that the points of a scan are drawn in.
struct PointGroups {
  std::vector<std::uint8_t> group{};  ///< Of each point: its place in `styles`.
  std::vector<rendering::PointStyle> styles{};
};

/// Unknown, ground, obstacle and outlier, by labels of any method or of the data set: its ground
/// classes are ground, 1 is outlier, 0 unknown, every other number obstacle.
PointGroups groups_by_label(std::span<const std::uint32_t> labels);

/// True and false, positive (ground) and negative, counted as `evaluate` does: points without an
/// answer are non-ground, classes that are ignored a group of their own. Throws
/// std::invalid_argument where the lengths differ.
PointGroups groups_by_error(std::span<const std::uint32_t> truth,
                            std::span<const std::uint32_t> labels);

}  // namespace groundgrid::program
