#pragma once

#include <span>

#include "core/point_transform.hpp"
#include "core/stages/plane_hierarchy.hpp"
#include "core/stages/rasterization.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// One scan in the window of the map: what every method gets.
struct Scan {
  std::span<const SensorPass> sensors;  ///< Points as they were measured.
  std::span<const Point3f> positions;   ///< Of the sensors.
  LocalPlane ground{};                  ///< The plane that the vehicle stands on.
};

/// What every method gives: one element a point, in the points' order.
struct Answers {
  std::span<Label> labels;
  std::span<float> height_above_ground;
};

/// Writes the answer to a point and counts it.
inline void give(std::size_t point, Label label, float height_above_ground, const Answers& answers,
                 LabelCounts& counts) {
  answers.labels[point] = label;
  answers.height_above_ground[point] = height_above_ground;
  switch (label) {
    case Label::unknown:
      ++counts.unknown;
      break;
    case Label::ground:
      ++counts.ground;
      break;
    case Label::obstacle:
      ++counts.obstacle;
      break;
    case Label::outlier:
      ++counts.outlier;
      break;
  }
}

}  // namespace groundgrid
