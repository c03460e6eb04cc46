#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace groundgrid::io {

/// The layouts of scan files that we read.
enum class ScanFormat : std::uint8_t {
  kitti,     ///< .bin: x y z intensity, 32-bit floats.
  nuscenes,  ///< .pcd.bin: x y z intensity ring, 32-bit floats.
  pcd,       ///< .pcd: Point Cloud Library, ascii, binary or binary_compressed.
  ply,       ///< .ply: ascii, binary of either byte order.
};

/// "kitti", "nuscenes", "pcd", "ply".
std::string_view name_of(ScanFormat format);

/// The format of that name, as --format takes it; nothing for another word.
std::optional<ScanFormat> scan_format_named(std::string_view name);

/// What the ending of a file's name says (.pcd.bin before .bin, and .BIN as .bin); nothing for
/// hidden files and other endings.
std::optional<ScanFormat> format_by_name(const std::filesystem::path& path);

/// A file's name without the ending of its format: "1532402927647951" of
/// "1532402927647951.pcd.bin".
std::string scan_stem(const std::filesystem::path& path);

}  // namespace groundgrid::io
