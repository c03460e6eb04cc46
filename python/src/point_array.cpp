#include "point_array.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

#include "core/input_checks.hpp"

namespace groundgrid::python {
namespace {

constexpr auto kFloatBytes = static_cast<std::ptrdiff_t>(sizeof(float));
/// No LiDAR gives so many numbers a point; more of them than points is an array that lies the other
/// way round, or an image.
constexpr std::size_t kMostColumns = 16;

/// A point of a copy: its coordinates, and its time where it has one.
struct Record {
  float x, y, z;
  float padding;
  double time;
};

template <typename Number>
Number number_at(const HeldBuffer& buffer, std::ptrdiff_t offset) {
  Number number;
  std::memcpy(&number, buffer.data() + offset, sizeof(Number));
  return number;
}

[[noreturn]] void reject_shape(const char* name, const char* expected, const HeldBuffer& buffer) {
  throw nb::value_error((std::string(name) + ": expected " + expected + ", got " +
                         description_of(buffer.array()).c_str())
                            .c_str());
}

[[noreturn]] void reject_number_type(const char* name, const char* expected,
                                     const HeldBuffer& buffer) {
  throw nb::type_error((std::string(name) + ": expected " + expected + ", got " +
                        description_of(buffer.array()).c_str() + "; convert it by astype()")
                           .c_str());
}

HeldBuffer checked_points(HeldBuffer points) {
  if (!points.holds('f') && !points.holds('d'))
    reject_number_type("points", "an array of float32 or float64", points);
  if (points.dimensions() != 2 || points.length(1) < 3)
    reject_shape("points", "an array of N rows with x, y, z first", points);
  if (points.length(1) > std::max(kMostColumns, points.length(0)) && points.length(0) > 0)
    reject_shape("points",
                 "a row for each point, x, y, z first; one with a column for each point is handed "
                 "over as points.T",
                 points);
  if (points.length(0) > kMaxPointsPerCall)
    throw nb::value_error(("points: more than " + std::to_string(kMaxPointsPerCall) +
                           " in one call; hand them over in parts")
                              .c_str());
  return points;
}

HeldBuffer checked_times(HeldBuffer times, std::size_t points) {
  if (!times.holds('f') && !times.holds('d') && !times.holds('I'))
    reject_number_type("times", "an array of float32, float64 or uint32", times);
  if (times.dimensions() != 1 || times.length(0) != points)
    reject_shape("times", ("an array of " + std::to_string(points) + " times, one a point").c_str(),
                 times);
  return times;
}

}  // namespace

PointArray::PointArray(nb::handle points, nb::handle times)
    : points_(checked_points(HeldBuffer(points, "points"))), is_float64_(points_.holds('d')) {
  if (!times.is_none()) times_.emplace(checked_times(HeldBuffer(times, "times"), size()));
}

bool PointArray::is_viewable() const {
  if (is_float64_ || times_) return false;
  return size() < 2 || points_.stride(0) >= 2 * std::abs(points_.stride(1)) + kFloatBytes;
}

PointView PointArray::view(std::vector<std::byte>& records) const {
  PointView view;
  view.count = size();
  if (view.count == 0) return view;
  if (is_viewable()) {
    const std::ptrdiff_t step = points_.stride(1);
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -2 * step);
    view.data = points_.data() - first;
    view.stride_bytes =
        static_cast<std::size_t>(size() < 2 ? 2 * std::abs(step) + kFloatBytes : points_.stride(0));
    view.x_offset = static_cast<std::size_t>(first);
    view.y_offset = static_cast<std::size_t>(first + step);
    view.z_offset = static_cast<std::size_t>(first + 2 * step);
    return view;
  }
  records.resize(view.count * sizeof(Record));
  for (std::size_t i = 0; i < view.count; ++i) {
    const Record record{coordinate(i, 0), coordinate(i, 1), coordinate(i, 2), 0.0F, time(i)};
    std::memcpy(records.data() + i * sizeof(Record), &record, sizeof(Record));
  }
  view.data = records.data();
  view.stride_bytes = sizeof(Record);
  if (times_) view.time_offset = offsetof(Record, time);
  view.time_type = TimeType::float64;
  return view;
}

std::pair<const std::byte*, const std::byte*> PointArray::extent() const {
  const std::byte* first = points_.data();
  const std::byte* last = first + (is_float64_ ? sizeof(double) : sizeof(float));
  if (size() == 0) return {first, first};
  const auto last_point = static_cast<std::ptrdiff_t>(size() - 1);
  for (const std::ptrdiff_t reach : {last_point * points_.stride(0), 2 * points_.stride(1)})
    (reach < 0 ? first : last) += reach;
  return {first, last};
}

float PointArray::coordinate(std::size_t point, int axis) const {
  const std::ptrdiff_t offset =
      static_cast<std::ptrdiff_t>(point) * points_.stride(0) + axis * points_.stride(1);
  return is_float64_ ? static_cast<float>(number_at<double>(points_, offset))
                     : number_at<float>(points_, offset);
}

double PointArray::time(std::size_t point) const {
  if (!times_) return 0.0;
  const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(point) * times_->stride(0);
  if (times_->holds('I')) return static_cast<double>(number_at<std::uint32_t>(*times_, offset));
  return times_->holds('d') ? number_at<double>(*times_, offset)
                            : static_cast<double>(number_at<float>(*times_, offset));
}

}  // namespace groundgrid::python
