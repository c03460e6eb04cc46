#include "io/pcd_writer.hpp"

#include <fmt/format.h>
#include <liblzf/lzf.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text_records.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "points are written as they lie");

char type_letter(FieldType type) {
  constexpr std::string_view kLetters = "IUIUIUIUFF";
  return kLetters[static_cast<std::size_t>(type)];
}

std::string header(const PointCloud& cloud, std::string_view encoding) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const PointField& field : cloud.fields) {
    fields += fmt::format(" {}", field.name);
    sizes += fmt::format(" {}", size_of(field.type));
    types += fmt::format(" {}", type_letter(field.type));
    counts += fmt::format(" {}", field.count);
  }
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n{}\n{}\n{}\n{}\nWIDTH {}\nHEIGHT "
      "{}\nVIEWPOINT {}\nPOINTS {}\nDATA {}\n",
      fields, sizes, types, counts, cloud.width, cloud.height,
      cloud.viewpoint.empty() ? "0 0 0 1 0 0 0" : cloud.viewpoint, cloud.size(), encoding);
}

// All x, then all y, and so on: neighbours in a field are alike and pack better.
std::vector<std::byte> field_by_field(const PointCloud& cloud) {
  std::vector<std::byte> planes(cloud.data.size());
  std::byte* plane = planes.data();
  for (const PointField& field : cloud.fields)
    for (std::size_t point = 0; point < cloud.size(); ++point) {
      const std::byte* const place = cloud.data.data() + point * cloud.stride_bytes + field.offset;
      std::memcpy(plane, place, field.bytes());
      plane += field.bytes();
    }
  return planes;
}

// The two sizes and the compressed points; empty where these would be no smaller.
std::vector<std::byte> compressed(const PointCloud& cloud) {
  if (cloud.data.size() > std::numeric_limits<std::uint32_t>::max()) return {};
  const std::vector<std::byte> planes = field_by_field(cloud);
  const auto size = static_cast<std::uint32_t>(planes.size());
  std::array<std::uint32_t, 2> sizes{0, size};
  std::vector<std::byte> packed(sizeof sizes + size);
  sizes[0] = lzf_compress(planes.data(), size, packed.data() + sizeof sizes, size);
  if (sizes[0] == 0) return {};
  std::memcpy(packed.data(), sizes.data(), sizeof sizes);
  packed.resize(sizeof sizes + sizes[0]);
  return packed;
}

}  // namespace

void write_pcd(const std::filesystem::path& path, const PointCloud& cloud, FileBatch* batch) {
  AtomicFile file(path);
  const std::vector<std::byte> packed = cloud.encoding == CloudEncoding::binary_compressed
                                            ? compressed(cloud)
                                            : std::vector<std::byte>{};
  if (cloud.encoding == CloudEncoding::ascii) {
    file.write(header(cloud, "ascii"));
    file.write(text_of_records(cloud));
  } else if (!packed.empty()) {
    file.write(header(cloud, "binary_compressed"));
    file.write(packed);
  } else {
    file.write(header(cloud, "binary"));
    file.write(cloud.data);
  }
  commit(std::move(file), batch);
}

}  // namespace groundgrid::io
