#include "io/field_copy.hpp"

#include <cstring>

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

}  // namespace groundgrid::io
