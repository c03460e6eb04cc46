#include "io/point_cloud.hpp"

#include <array>
#include <cstring>
#include <utility>

#include "io/field_number.hpp"

namespace groundgrid::io {
namespace {

template <typename Number>
double number_at(const std::byte* place) {
  Number number;
  std::memcpy(&number, place, sizeof number);
  return static_cast<double>(number);
}

bool is_float32(const PointCloud& cloud, std::string_view name) {
  return cloud.find(name)->type == FieldType::float32;
}

}  // namespace

std::size_t size_of(FieldType type) {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes.at(static_cast<std::size_t>(type));
}

std::string_view name_of(FieldType type) {
  constexpr std::array<std::string_view, 10> kNames{"int8",    "uint8",  "int16", "uint16",
                                                    "int32",   "uint32", "int64", "uint64",
                                                    "float32", "float64"};
  return kNames.at(static_cast<std::size_t>(type));
}

const PointField* PointCloud::find(std::string_view name) const {
  for (const PointField& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

void PointCloud::add_field(std::string name, FieldType type, std::size_t count) {
  fields.push_back({std::move(name), type, stride_bytes, count});
  stride_bytes += fields.back().bytes();
}

void PointCloud::clear() {
  std::vector<std::byte> memory = std::move(data);
  memory.clear();
  *this = {};
  data = std::move(memory);
}

double value_at(const PointCloud& cloud, std::size_t point, const PointField& field) {
  const std::byte* const place = cloud.data.data() + point * cloud.stride_bytes + field.offset;
  return with_number(field.type, [&](auto zero) { return number_at<decltype(zero)>(place); });
}

PointView point_view(const PointCloud& cloud, std::vector<float>& coordinates) {
  const PointField& x = *cloud.find("x");
  const PointField& y = *cloud.find("y");
  const PointField& z = *cloud.find("z");
  if (is_float32(cloud, "x") && is_float32(cloud, "y") && is_float32(cloud, "z"))
    return {cloud.data.data(), cloud.size(), cloud.stride_bytes, x.offset, y.offset, z.offset};
  coordinates.resize(cloud.size() * 3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    coordinates[3 * i] = static_cast<float>(value_at(cloud, i, x));
    coordinates[3 * i + 1] = static_cast<float>(value_at(cloud, i, y));
    coordinates[3 * i + 2] = static_cast<float>(value_at(cloud, i, z));
  }
  return PointView::from_floats(coordinates.data(), cloud.size(), 3);
}

}  // namespace groundgrid::io
