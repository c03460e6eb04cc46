#include "io/scan_format.hpp"

#include <array>

#include "io/text.hpp"

namespace groundgrid::io {
namespace {

struct NamedFormat {
  ScanFormat format;
  std::string_view name;
  std::string_view ending;
};

// .pcd.bin stands before .bin, since it ends in it too.
constexpr std::array<NamedFormat, 6> kFormats{{{ScanFormat::nuscenes, "nuscenes", ".pcd.bin"},
                                               {ScanFormat::kitti, "kitti", ".bin"},
                                               {ScanFormat::pcd, "pcd", ".pcd"},
                                               {ScanFormat::ply, "ply", ".ply"},
                                               {ScanFormat::text, "text", ".xyz"},
                                               {ScanFormat::text, "text", ".pts"}}};

const NamedFormat* format_of(const std::string& file_name) {
  if (file_name.empty() || file_name.front() == '.') return nullptr;
  for (const NamedFormat& format : kFormats)
    if (ends_with_in_any_case(file_name, format.ending)) return &format;
  return nullptr;
}

}  // namespace

std::string name_of(const ScanFormat& format) {
  for (const NamedFormat& known : kFormats)
    if (known.format == format) return std::string(known.name);
  return format.layout.name();
}

std::optional<ScanFormat> scan_format_named(std::string_view name) {
  for (const NamedFormat& known : kFormats)
    if (known.name == name) return known.format;
  if (const auto layout = BinLayout::named(name)) return ScanFormat{ScanFormat::Kind::bin, *layout};
  return std::nullopt;
}

std::optional<ScanFormat> format_by_name(const std::filesystem::path& path) {
  const NamedFormat* const format = format_of(path.filename().string());
  return format == nullptr ? std::nullopt : std::optional(format->format);
}

std::optional<ScanFormat> format_by_any_name(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with('.') &&
      (ends_with_in_any_case(name, ".csv") || ends_with_in_any_case(name, ".txt")))
    return ScanFormat::text;
  return format_by_name(path);
}

std::string scan_stem(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const NamedFormat* const format = format_of(name);
  return format == nullptr ? path.stem().string()
                           : name.substr(0, name.size() - format->ending.size());
}

}  // namespace groundgrid::io
