#pragma once

#include <cstddef>
#include <string>

#include "evaluation/segmentation_metrics.hpp"

namespace groundgrid::evaluation {

inline double bin_begin_m(std::size_t bin) { return static_cast<double>(bin) * kDistanceBinM; }

/// "10-20", "> 50": metres.
inline std::string bin_name(std::size_t bin) {
  const auto metres = [](std::size_t i) {
    return std::to_string(static_cast<int>(bin_begin_m(i)));
  };
  if (bin + 1 == kDistanceBins) return "> " + metres(bin);
  return metres(bin) + "-" + metres(bin + 1);
}

/// The bin of all that is farther is shown only where it holds points.
inline bool bin_is_left_out(std::size_t bin, const Tally& tally) {
  return bin + 1 == kDistanceBins && tally.points() == 0;
}

}  // namespace groundgrid::evaluation
