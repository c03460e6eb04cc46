#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace groundgrid::evaluation {

/// How honest the standard deviations of estimated heights are, over the cells of a group. Of
/// normal errors 68.3 % lie within one standard deviation and 95.4 % within two. NaN without cells.
struct DeviationCalibration {
  std::uint64_t cells = 0;  ///< With an error and a standard deviation.
  double within_one = std::numeric_limits<double>::quiet_NaN();  ///< Share of the errors, 0 to 1.
  double within_two = std::numeric_limits<double>::quiet_NaN();
  double median_m = std::numeric_limits<double>::quiet_NaN();  ///< Of the standard deviations.
};

/// An error of a height, estimate less reference, and what the estimate says of it, metres.
struct JudgedHeight {
  double error_m = 0.0;
  double deviation_m = 0.0;
};

DeviationCalibration calibrate(std::span<const JudgedHeight> heights);

}  // namespace groundgrid::evaluation
