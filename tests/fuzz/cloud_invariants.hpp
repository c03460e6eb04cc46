#pragma once

#include <cstring>
#include <vector>

#include "io/error.hpp"
#include "io/scan_file.hpp"
#include "memory_file.hpp"

namespace groundgrid::fuzz {

/// What holds for every cloud that was read, whatever the file.
inline void require_whole_cloud(const io::PointCloud& cloud) {
  require(cloud.data.size() == cloud.size() * cloud.stride_bytes, "the records are all there");
  std::size_t end = 0;
  for (const io::PointField& field : cloud.fields) {
    require(field.offset == end && field.count > 0, "fields follow one another");
    end += field.bytes();
  }
  require(end == cloud.stride_bytes, "the fields fill the record");
  std::vector<float> coordinates;
  const PointView view = point_view(cloud, coordinates);
  require(view.count == cloud.size(), "the view has all points");
  for (std::size_t i = 0; i < view.count; ++i)
    for (const std::size_t offset : {view.x_offset, view.y_offset, view.z_offset}) {
      float coordinate = 0.0F;
      std::memcpy(&coordinate, view.data + i * view.stride_bytes + offset, sizeof coordinate);
    }
}

/// Reads the bytes as a scan; an Error is a right answer too, and leaves an empty cloud.
inline void read_as(io::ScanFormat format, const std::uint8_t* bytes, std::size_t size) {
  const MemoryFile file(bytes, size);
  static io::PointCloud cloud;
  try {
    read_scan(file.path(), format, cloud);
  } catch (const io::Error&) {
    require(cloud.size() == 0 && cloud.fields.empty(), "a cloud that was not read is empty");
    return;
  }
  require_whole_cloud(cloud);
}

}  // namespace groundgrid::fuzz
