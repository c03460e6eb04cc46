#include "io/binary_records.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/error.hpp"

namespace groundgrid::io {

void require_records(const InputFile& file, const PointCloud& cloud) {
  if (cloud.size() > 0 && file.remaining() / cloud.stride_bytes < cloud.size())
    throw Error({.file = file.path(),
                 .offset = file.position(),
                 .expected = fmt::format("{} points of {} bytes, as the header promises",
                                         cloud.size(), cloud.stride_bytes),
                 .got = fmt::format("{} bytes, which hold {}", file.remaining(),
                                    file.remaining() / cloud.stride_bytes),
                 .remedy = "the file is cut short; fetch it again"});
}

void read_binary_records(InputFile& file, PointCloud& cloud) {
  require_records(file, cloud);
  file.read_into(cloud.data, cloud.size() * cloud.stride_bytes);
}

void swap_bytes(PointCloud& cloud) {
  for (const PointField& field : cloud.fields) {
    const std::size_t bytes = size_of(field.type);
    if (bytes == 1) continue;
    for (std::size_t point = 0; point < cloud.size(); ++point) {
      std::byte* const begin = cloud.data.data() + point * cloud.stride_bytes + field.offset;
      for (std::size_t i = 0; i < field.count; ++i)
        std::reverse(begin + i * bytes, begin + (i + 1) * bytes);
    }
  }
}

}  // namespace groundgrid::io
