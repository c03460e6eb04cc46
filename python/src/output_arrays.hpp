#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>

#include "groundgrid/ground_grid.hpp"
#include "held_buffer.hpp"
#include "scan_arrays.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// The two arrays that a call writes into: new ones, or the caller's.
class OutputArrays {
 public:
  /// `out` is None or the pair (labels, heights): uint8 and float32, one element a point, packed,
  /// writable, and apart from each other and from the points. Throws TypeError and ValueError,
  /// which begin with "out".
  OutputArrays(nb::handle out, const ScanArrays& scans);

  [[nodiscard]] const nb::object& labels() const { return labels_; }
  [[nodiscard]] const nb::object& heights() const { return heights_; }
  [[nodiscard]] ScanOutput spans() const;

 private:
  OutputArrays(nb::object labels, nb::object heights, const ScanArrays& scans);

  nb::object labels_;
  nb::object heights_;
  HeldBuffer label_buffer_;
  HeldBuffer height_buffer_;
};

}  // namespace groundgrid::python
