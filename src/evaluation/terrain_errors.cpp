#include "evaluation/terrain_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace groundgrid::evaluation {
namespace {

/// The value that would stand at that place if they were sorted.
double value_at(std::vector<double>& values, std::size_t place) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double TerrainErrors::coverage() const {
  return static_cast<double>(covered) / static_cast<double>(cells);
}

TerrainErrors terrain_errors(std::uint64_t cells, std::vector<double> errors_m) {
  TerrainErrors figures{.cells = cells, .covered = errors_m.size()};
  if (errors_m.empty()) return figures;
  double sum = 0.0;
  double sum_sizes = 0.0;
  double sum_squares = 0.0;
  for (double& error : errors_m) {
    sum += error;
    sum_squares += error * error;
    error = std::abs(error);
    sum_sizes += error;
  }
  const auto count = static_cast<double>(errors_m.size());
  figures.rmse_m = std::sqrt(sum_squares / count);
  figures.mae_m = sum_sizes / count;
  figures.bias_m = sum / count;
  // In whole numbers: 0.95 · 20 is a little more than 19 in binary.
  figures.p95_m = value_at(errors_m, (errors_m.size() * 95 + 99) / 100 - 1);
  return figures;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t middle = values.size() / 2;
  const double upper = value_at(values, middle);
  if (values.size() % 2 == 1) return upper;
  const auto end_of_lower = values.begin() + static_cast<std::ptrdiff_t>(middle);
  return (*std::max_element(values.begin(), end_of_lower) + upper) / 2.0;
}

}  // namespace groundgrid::evaluation
