#pragma once

#include <cstdint>
#include <string>

namespace groundgrid::evaluation {

/// What a class counts as in the figures.
enum class Truth : std::uint8_t { ignored, ground, non_ground };

/// Ground: road 40, parking 44, sidewalk 48, other-ground 49, lane-marking 60, terrain 72.
/// Ignored: unlabeled 0, outlier 1, vegetation 70. All others, unknown numbers too: non-ground.
Truth truth_of(std::uint16_t semantic_kitti_class);

/// The name of a class in the data set ("road"); its number where the data set has no such class.
std::string class_name(std::uint16_t semantic_kitti_class);

/// The name of what a class counts as: "ground", "non-ground", "ignored".
const char* truth_name(Truth truth);

}  // namespace groundgrid::evaluation
