#include "array_output.hpp"

namespace groundgrid::python {
namespace {

void append(const Eigen::Isometry3d& transform, std::vector<double>& numbers) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) numbers.push_back(transform(row, column));
}

}  // namespace

nb::object to_array(std::span<const Eigen::Isometry3d> transforms) {
  std::vector<double> numbers;
  for (const Eigen::Isometry3d& transform : transforms) append(transform, numbers);
  return to_array(std::move(numbers), {transforms.size(), 4, 4});
}

nb::object to_array(const Eigen::Isometry3d& transform) {
  std::vector<double> numbers;
  append(transform, numbers);
  return to_array(std::move(numbers), {4, 4});
}

}  // namespace groundgrid::python
