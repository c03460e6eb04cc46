#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace groundgrid::evaluation {

/// How far estimated heights are from those of a reference, over the cells of a group. Errors are
/// estimate less reference, metres; NaN where no cell is covered.
struct TerrainErrors {
  std::uint64_t cells = 0;    ///< With a reference height.
  std::uint64_t covered = 0;  ///< Those of them that have an estimated height.
  double rmse_m = std::numeric_limits<double>::quiet_NaN();  ///< Root of the mean squared error.
  double mae_m = std::numeric_limits<double>::quiet_NaN();   ///< Mean of the errors' sizes.
  double bias_m = std::numeric_limits<double>::quiet_NaN();  ///< Mean error; above 0: too high.
  /// The least size of error that 95 % of the covered cells do not exceed.
  double p95_m = std::numeric_limits<double>::quiet_NaN();

  /// Share of the cells that are covered, 0 to 1; NaN without cells.
  [[nodiscard]] double coverage() const;
};

/// The figures of a group of so many cells, the covered ones of which have these errors.
TerrainErrors terrain_errors(std::uint64_t cells, std::vector<double> errors_m);

/// The middle value, or the mean of the two in the middle; NaN where there are none.
double median(std::vector<double> values);

}  // namespace groundgrid::evaluation
