#pragma once

#include <nanobind/nanobind.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <mutex>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "scan_arrays.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// Of the base, at the begin and the end of a scan.
struct Poses {
  Eigen::Isometry3d begin;
  Eigen::Isometry3d end;
};

/// One map, whose callers take turns: Python's threads run while it works.
class SharedGrid {
 public:
  explicit SharedGrid(const Config& config) : grid_(config) {}

  ScanResult process(const ScanArrays& scans, const Poses& poses, const ScanOutput& output) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return grid_.process(scans.views(copies_), poses.begin, poses.end, output);
  }

  /// What `read` makes of the map as it stands; it runs without the GIL.
  template <typename Read>
  auto visit(const Read& read) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return read(grid_);
  }

  void reset() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    grid_.reset();
  }

  /// Never changes.
  [[nodiscard]] const Config& config() const { return grid_.config(); }

 private:
  std::mutex mutex_;
  GroundGrid grid_;
  std::vector<std::vector<std::byte>> copies_;  ///< Reused from call to call.
};

}  // namespace groundgrid::python
