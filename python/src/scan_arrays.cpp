#include "scan_arrays.hpp"

#include <nanobind/stl/pair.h>

#include <algorithm>
#include <utility>

#include "array_input.hpp"

namespace groundgrid::python {
namespace {

std::pair<double, double> interval(const ScanArguments& arguments) {
  std::pair<double, double> span{0.0, 0.0};
  if (arguments.times.is_none() != arguments.time_span.is_none())
    throw nb::value_error("times: expected together with time_span, their begin and end");
  if (!arguments.time_span.is_none() && !nb::try_cast(arguments.time_span, span))
    throw nb::type_error("time_span: expected two numbers, begin and end");
  return span;
}

}  // namespace

ScanArrays::ScanArrays(const std::vector<ScanArguments>& scans) {
  scans_.reserve(scans.size());
  for (const ScanArguments& scan : scans) add(scan);
}

void ScanArrays::add(const ScanArguments& arguments) {
  const auto [begin, end] = interval(arguments);
  std::optional<RigidTransform> mounting;
  if (!arguments.mounting.is_none()) mounting = transform_from(arguments.mounting, "mounting");
  scans_.push_back({PointArray(arguments.points, arguments.times), mounting, begin, end});
  have_times_ = have_times_ || !arguments.times.is_none();
}

std::size_t ScanArrays::points() const {
  std::size_t points = 0;
  for (const Scan& scan : scans_) points += scan.points.size();
  return points;
}

bool ScanArrays::overlap(const std::byte* begin, const std::byte* end) const {
  return std::any_of(scans_.begin(), scans_.end(), [&](const Scan& scan) {
    const auto [first, last] = scan.points.extent();
    return begin < last && first < end;
  });
}

std::vector<SensorScan> ScanArrays::views(std::vector<std::vector<std::byte>>& copies) const {
  if (copies.size() < scans_.size()) copies.resize(scans_.size());
  std::vector<SensorScan> views;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const Scan& scan = scans_[i];
    views.push_back({scan.points.view(copies[i]), scan.mounting, scan.time_begin, scan.time_end});
  }
  return views;
}

}  // namespace groundgrid::python
