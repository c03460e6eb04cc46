#pragma once

#include <nanobind/nanobind.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "held_buffer.hpp"

namespace groundgrid::python {

/// Numbers of one type, one after the other, of an array of any layout: a copy where it has another
/// one. Made and destroyed with the GIL held.
class PackedArray {
 public:
  /// Of float32 from an array of floats or integers, or of uint32 from an array of integers from 0
  /// on. Throws TypeError or ValueError, which begin with `name`, for other types and numbers.
  static PackedArray floats(nb::handle array, const char* name);
  static PackedArray labels(nb::handle array, const char* name);

  [[nodiscard]] int dimensions() const { return buffer_.dimensions(); }
  [[nodiscard]] std::size_t length(int dimension) const { return buffer_.length(dimension); }
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] nb::handle array() const { return buffer_.array(); }

  [[nodiscard]] std::span<const float> as_floats() const {
    return {reinterpret_cast<const float*>(buffer_.data()), size()};
  }
  [[nodiscard]] std::span<const std::uint32_t> as_labels() const {
    return {reinterpret_cast<const std::uint32_t*>(buffer_.data()), size()};
  }

 private:
  explicit PackedArray(HeldBuffer buffer) : buffer_(std::move(buffer)) {}

  HeldBuffer buffer_;
};

/// A transform from an array of 4 × 4 or 3 × 4 numbers, [R | t]; the identity from None. Throws
/// TypeError or ValueError, which begin with `name`, for all else. That R is a rotation is left to
/// the core to check.
Eigen::Isometry3d transform_from(nb::handle array, const char* name);

}  // namespace groundgrid::python
