#include "io/field_copy.hpp"

#include <cstring>
#include <utility>

#include "io/coordinate_fields.hpp"

namespace groundgrid::io {

void FieldCopy::add(const PointField& field, PointCloud& to) {
  to.add_field(field.name, field.type, field.count);
  const std::size_t place = to.fields.back().offset;
  if (!parts_.empty() && parts_.back().from + parts_.back().bytes == field.offset &&
      parts_.back().to + parts_.back().bytes == place)
    parts_.back().bytes += field.bytes();
  else
    parts_.push_back({field.offset, place, field.bytes()});
}

void FieldCopy::copy(const std::byte* from, std::size_t from_stride, std::byte* to,
                     std::size_t to_stride, std::size_t points) const {
  for (std::size_t point = 0; point < points; ++point)
    for (const Part& part : parts_)
      std::memmove(to + point * to_stride + part.to, from + point * from_stride + part.from,
                   part.bytes);
}

void drop_padding(PointCloud& cloud) {
  const std::vector<PointField> fields = std::exchange(cloud.fields, {});
  const std::size_t stride = std::exchange(cloud.stride_bytes, 0);
  FieldCopy copy;
  for (const PointField& field : fields)
    if (field.name != kPaddingName) copy.add(field, cloud);
  if (cloud.stride_bytes == stride) return;
  copy.copy(cloud.data.data(), stride, cloud.data.data(), cloud.stride_bytes, cloud.size());
  cloud.data.resize(cloud.size() * cloud.stride_bytes);
}

}  // namespace groundgrid::io
