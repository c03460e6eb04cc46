#include "io/bin_scan.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bin_layout_guess.hpp"
#include "io/error.hpp"
#include "io/field_copy.hpp"
#include "io/input_file.hpp"
#include "io/scan_format.hpp"

namespace groundgrid::io {
namespace {

static_assert(std::endian::native == std::endian::little, "scans are read as they lie on disk");

std::string names_of(std::span<const BinLayout> layouts) {
  std::string names;
  for (const BinLayout& layout : layouts)
    names += fmt::format("{}{} ({})", names.empty() ? "" : " or ",
                         name_of(ScanFormat{ScanFormat::Kind::bin, layout}), layout.words());
  return names;
}

std::string remedy_for_size(std::uintmax_t bytes) {
  if (bytes % kNuscenesLayout.bytes() == 0)
    return "if it is a nuScenes scan, use --format nuscenes";
  if (bytes % kKittiLayout.bytes() == 0) return "if it is a KITTI scan, use --format kitti";
  return "the file is cut short or has another layout; fetch it again, or say what it is with "
         "--format";
}

void require_whole_points(const InputFile& file, const BinLayout& layout) {
  // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): a layout has x, y and z at least.
  const std::uintmax_t rest = file.size() % layout.bytes();
  if (rest == 0) return;
  throw Error(
      {.file = file.path(),
       .offset = file.size() - rest,
       .expected = fmt::format("whole points of {} bytes ({})", layout.bytes(), layout.words()),
       .got = fmt::format("{} bytes after the last whole one", rest),
       .remedy = remedy_for_size(file.size())});
}

void require_likely(const std::filesystem::path& path, const BinLayout& layout,
                    const PointCloud& cloud) {
  if (cloud.size() == 0) return;
  const std::vector<BinLayout> likely = likely_layouts(cloud.data, layout);
  if (likely.size() == 1 && likely.front() == layout) return;
  if (likely.empty())
    throw Error(
        {.file = path,
         .expected = fmt::format("coordinates in metres ({})", layout.words()),
         .got = "numbers that are none in any layout that we know",
         .remedy = fmt::format("if it is a scan, say its layout with --format: {}", kFormatNames)});
  throw Error({.file = path,
               .expected = fmt::format("points of {}", layout.words()),
               .got = fmt::format("numbers that lie as in {}", names_of(likely)),
               .remedy = "say the layout with --format"});
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

void read_numbers(const std::filesystem::path& path, const BinLayout& layout, PointCloud& cloud) {
  layout.add_fields(cloud);
  InputFile file(path);
  require_no_header(file);
  require_whole_points(file, layout);
  cloud.width = static_cast<std::size_t>(file.size()) / cloud.stride_bytes;
  file.read_into(cloud.data, cloud.size() * cloud.stride_bytes);
}

}  // namespace

void read_bin_scan(const std::filesystem::path& path, const BinLayout& layout, PointCloud& cloud) {
  read_numbers(path, layout, cloud);
  drop_padding(cloud);
}

void read_bin_scan_if_likely(const std::filesystem::path& path, const BinLayout& layout,
                             PointCloud& cloud) {
  read_numbers(path, layout, cloud);
  require_likely(path, layout, cloud);
}

std::optional<BinLayout> guess_layout(const std::filesystem::path& path, const BinLayout& usual) {
  try {
    InputFile file(path);
    require_no_header(file);
    std::vector<std::byte> bytes;
    file.read_into(bytes, static_cast<std::size_t>(file.size()));
    const std::vector<BinLayout> likely = likely_layouts(bytes, usual);
    if (!bytes.empty() && likely.size() == 1) return likely.front();
  } catch (const Error&) {  // Reading the scan says so again, to whom it concerns.
  }
  return std::nullopt;
}

}  // namespace groundgrid::io
