#pragma once

#include <cstdint>

#include "groundgrid/ground_grid.hpp"

namespace groundgrid::program {

/// Points by answer.
struct LabelCounts {
  std::uint64_t ground = 0;
  std::uint64_t obstacle = 0;
  std::uint64_t outlier = 0;
  std::uint64_t unknown = 0;

  [[nodiscard]] std::uint64_t points() const { return ground + obstacle + outlier + unknown; }

  void add(const LabelCounts& other) {
    ground += other.ground;
    obstacle += other.obstacle;
    outlier += other.outlier;
    unknown += other.unknown;
  }
};

inline LabelCounts counts_of(const ScanResult& result) {
  return {result.ground, result.obstacle, result.outlier, result.unknown};
}

}  // namespace groundgrid::program
