#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "scan_arrays.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// Of the base, at the begin of a scan, if it is to be deskewed, and at its end.
struct Poses {
  std::optional<RigidTransform> begin;
  RigidTransform end;
};

/// One map, whose callers take turns: Python's threads run while it works.
class SharedGrid {
 public:
  SharedGrid(const Config& config, int threads) : grid_(config, threads) {}

  ScanResult process(const ScanArrays& scans, const Poses& poses, const ScanOutput& output) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    const std::vector<SensorScan> views = scans.views(copies_);
    return grid_.process({views, poses.end, poses.begin, output});
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
