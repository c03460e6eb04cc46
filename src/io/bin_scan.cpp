#include "io/bin_scan.hpp"

#include <fmt/format.h>

#include <bit>
#include <string>
#include <string_view>
#include <utility>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/scan_format.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "scans are read as they lie on disk");

constexpr std::size_t kKittiBytes = 4 * sizeof(float);
constexpr std::size_t kNuscenesBytes = 5 * sizeof(float);

std::string remedy_for_size(std::uintmax_t bytes, ScanFormat format) {
  if (format == ScanFormat::kitti && bytes % kNuscenesBytes == 0)
    return "if it is a nuScenes scan, use --format nuscenes";
  if (format == ScanFormat::nuscenes && bytes % kKittiBytes == 0)
    return "if it is a KITTI scan, use --format kitti";
  return "the file is cut short or has another layout; fetch it again, or say what it is with "
         "--format";
}

void require_whole_points(const InputFile& file, ScanFormat format) {
  const bool kitti = format == ScanFormat::kitti;
  const std::size_t stride = kitti ? kKittiBytes : kNuscenesBytes;
  const std::uintmax_t rest = file.size() % stride;
  if (rest == 0) return;
  throw Error(
      {.file = file.path(),
       .offset = file.size() - rest,
       .expected = fmt::format("whole points of {} bytes (x y z intensity{} as 32-bit floats)",
                               stride, kitti ? "" : " ring"),
       .got = fmt::format("{} bytes after the last whole one", rest),
       .remedy = remedy_for_size(file.size(), format)});
}

// No scan begins with these letters: as coordinates they are beyond the moon or next to nothing.
void require_no_header(InputFile& file) {
  const std::string begin = file.peek(8);
  for (const auto& [letters, format] :
       {std::pair<std::string_view, ScanFormat>{"# .PCD", ScanFormat::pcd},
        {"VERSION ", ScanFormat::pcd},
        {"ply\n", ScanFormat::ply},
        {"ply\r\n", ScanFormat::ply}})
    if (begin.starts_with(letters))
      throw Error({.file = file.path(),
                   .offset = 0,
                   .expected = "points as 32-bit floats without a header",
                   .got = fmt::format("the header of a {} file", name_of(format)),
                   .remedy = fmt::format("use --format {}", name_of(format))});
}

void read_floats(const std::filesystem::path& path, ScanFormat format, PointCloud& cloud) {
  for (const char* const name : {"x", "y", "z", "intensity"})
    cloud.add_field(name, FieldType::float32);
  if (format == ScanFormat::nuscenes) cloud.add_field("ring", FieldType::float32);
  InputFile file(path);
  require_no_header(file);
  require_whole_points(file, format);
  cloud.width = static_cast<std::size_t>(file.size()) / cloud.stride_bytes;
  file.read_into(cloud.data, cloud.size() * cloud.stride_bytes);
}

}  // namespace

void read_kitti_scan(const std::filesystem::path& path, PointCloud& cloud) {
  read_floats(path, ScanFormat::kitti, cloud);
}

void read_nuscenes_scan(const std::filesystem::path& path, PointCloud& cloud) {
  read_floats(path, ScanFormat::nuscenes, cloud);
}

}  // namespace groundgrid::io
