#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <vector>

#include "groundgrid/scan.hpp"
#include "point_array.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// What Python hands over of one sensor: SensorScan of the package.
struct ScanArguments {
  nb::object points;
  nb::object mounting;   ///< T_base_sensor, or None.
  nb::object times;      ///< Or None.
  nb::object time_span;  ///< Begin and end, or None.
};

/// The scans of one call: arrays that are held, and views of them. Made and destroyed with the GIL
/// held.
class ScanArrays {
 public:
  /// Throws TypeError and ValueError, which begin with the name of what is wrong.
  explicit ScanArrays(const std::vector<ScanArguments>& scans);

  /// Of all scans together.
  [[nodiscard]] std::size_t points() const;
  /// Whether a scan has times.
  [[nodiscard]] bool have_times() const { return have_times_; }
  /// Whether the points of a scan lie somewhere in this memory.
  [[nodiscard]] bool overlap(const std::byte* begin, const std::byte* end) const;

  /// Views that live as long as this, and `copies`, which are made where they must be. Needs no
  /// GIL.
  std::vector<SensorScan> views(std::vector<std::vector<std::byte>>& copies) const;

 private:
  struct Scan {
    PointArray points;
    std::optional<RigidTransform> mounting;
    double time_begin;
    double time_end;
  };
  void add(const ScanArguments& arguments);

  std::vector<Scan> scans_;
  bool have_times_ = false;
};

}  // namespace groundgrid::python
