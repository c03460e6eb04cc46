#include "evaluation/deviation_calibration.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "evaluation/terrain_errors.hpp"

namespace groundgrid::evaluation {

DeviationCalibration calibrate(std::span<const JudgedHeight> heights) {
  DeviationCalibration figures{.cells = heights.size()};
  if (heights.empty()) return figures;
  std::size_t within_one = 0;
  std::size_t within_two = 0;
  std::vector<double> deviations;
  deviations.reserve(heights.size());
  for (const JudgedHeight& height : heights) {
    const double error = std::abs(height.error_m);
    if (error <= height.deviation_m) ++within_one;
    if (error <= 2.0 * height.deviation_m) ++within_two;
    deviations.push_back(height.deviation_m);
  }
  const auto count = static_cast<double>(heights.size());
  figures.within_one = static_cast<double>(within_one) / count;
  figures.within_two = static_cast<double>(within_two) / count;
  figures.median_m = median(std::move(deviations));
  return figures;
}

}  // namespace groundgrid::evaluation
