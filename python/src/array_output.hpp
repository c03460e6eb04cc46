#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace groundgrid::python {

namespace nb = nanobind;

/// A NumPy array that owns what was the vector's memory.
template <typename Number>
nb::object to_array(std::vector<Number> numbers, std::initializer_list<std::size_t> shape) {
  auto owned = std::make_unique<std::vector<Number>>(std::move(numbers));
  Number* const data = owned->data();
  const nb::capsule owner(owned.release(), [](void* memory) noexcept {
    delete static_cast<std::vector<Number>*>(memory);
  });
  return nb::cast(nb::ndarray<nb::numpy, Number>(data, shape, owner), nb::rv_policy::reference);
}

/// N × 4 × 4 float64: one matrix a transform.
nb::object to_array(std::span<const Eigen::Isometry3d> transforms);

/// 4 × 4 float64.
nb::object to_array(const Eigen::Isometry3d& transform);

}  // namespace groundgrid::python
