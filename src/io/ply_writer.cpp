#include "io/ply_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "io/binary_records.hpp"
#include "io/error.hpp"
#include "io/text_records.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "points are written as they lie");

// Each takes a line in the header and a PointField in memory.
constexpr std::size_t kMostProperties = 4096;

void require_few_properties(const std::filesystem::path& path, const PointCloud& cloud) {
  std::size_t properties = 0;
  for (const PointField& field : cloud.fields) properties += field.count;
  if (properties <= kMostProperties) return;
  throw Error({.file = path,
               .expected = fmt::format("at most {} numbers a point, which PLY holds as so many "
                                       "properties",
                                       kMostProperties),
               .got = fmt::format("{}", properties),
               .remedy = "write them with --clouds pcd"});
}

bool is_wide_integer(FieldType type) {
  return type == FieldType::int64 || type == FieldType::uint64;
}

std::string_view ply_name(FieldType type) {
  constexpr std::array<std::string_view, 10> kNames{"char", "uchar", "short", "ushort", "int",
                                                    "uint", "",      "",      "float",  "double"};
  return kNames.at(static_cast<std::size_t>(type));
}

/// Gives the numbers of a field of several a name each that no other field has.
class PropertyNames {
 public:
  explicit PropertyNames(const PointCloud& cloud) {
    for (const PointField& field : cloud.fields) taken_.insert(field.name);
  }

  std::string name(const PointField& field, std::size_t i) {
    if (field.count == 1) return field.name;
    std::string name = fmt::format("{}_{}", field.name, i);
    while (!taken_.insert(name).second) name += '_';
    return name;
  }

 private:
  std::set<std::string> taken_;
};

// The same bytes, with a field for each number.
PointCloud with_single_numbers(const PointCloud& cloud) {
  PropertyNames names(cloud);
  PointCloud single;
  for (const PointField& field : cloud.fields)
    for (std::size_t i = 0; i < field.count; ++i)
      single.add_field(names.name(field, i), field.type);
  single.width = cloud.size();
  single.encoding = cloud.encoding;
  single.data = cloud.data;
  return single;
}

// An integer of 64 bits takes the room of a double, so that it is replaced in its place.
void make_doubles(PointCloud& cloud) {
  for (PointField& field : cloud.fields) {
    if (!is_wide_integer(field.type)) continue;
    for (std::size_t point = 0; point < cloud.size(); ++point) {
      const double number = value_at(cloud, point, field);
      std::memcpy(cloud.data.data() + point * cloud.stride_bytes + field.offset, &number,
                  sizeof number);
    }
    field.type = FieldType::float64;
  }
}

std::string header(const PointCloud& cloud) {
  std::string_view format = "binary_little_endian";
  if (cloud.encoding == CloudEncoding::ascii) format = "ascii";
  if (cloud.encoding == CloudEncoding::binary_big_endian) format = "binary_big_endian";
  std::string text = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n", format, cloud.size());
  for (const PointField& field : cloud.fields)
    text += fmt::format("property {} {}\n", ply_name(field.type), field.name);
  return text + "end_header\n";
}

}  // namespace

void write_ply(const std::filesystem::path& path, const PointCloud& cloud, FileBatch* batch) {
  require_few_properties(path, cloud);
  AtomicFile file(path);
  PointCloud vertices = with_single_numbers(cloud);
  make_doubles(vertices);
  file.write(header(vertices));
  if (vertices.encoding == CloudEncoding::ascii) {
    file.write(text_of_records(vertices));
  } else {
    if (vertices.encoding == CloudEncoding::binary_big_endian) swap_bytes(vertices);
    file.write(vertices.data);
  }
  commit(std::move(file), batch);
}

}  // namespace groundgrid::io
