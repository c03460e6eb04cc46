#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/bin_layout.hpp"

namespace groundgrid::io {

/// How a scan's file is to be read.
struct ScanFormat {
  enum class Kind : std::uint8_t {
    bin,   ///< Numbers without a header, as `layout` has them.
    pcd,   ///< Point Cloud Library, ascii, binary or binary_compressed.
    ply,   ///< ascii, binary of either byte order.
    text,  ///< A point a line, of any endings that text has.
  };

  Kind kind = Kind::bin;
  BinLayout layout = kKittiLayout;  ///< Of Kind::bin only.

  static const ScanFormat kitti;     ///< x y z intensity, 32-bit floats.
  static const ScanFormat nuscenes;  ///< x y z intensity ring, 32-bit floats.
  static const ScanFormat pcd;
  static const ScanFormat ply;
  static const ScanFormat text;

  bool operator==(const ScanFormat&) const = default;
};

inline constexpr ScanFormat ScanFormat::kitti{ScanFormat::Kind::bin, kKittiLayout};
inline constexpr ScanFormat ScanFormat::nuscenes{ScanFormat::Kind::bin, kNuscenesLayout};
inline constexpr ScanFormat ScanFormat::pcd{ScanFormat::Kind::pcd};
inline constexpr ScanFormat ScanFormat::ply{ScanFormat::Kind::ply};
inline constexpr ScanFormat ScanFormat::text{ScanFormat::Kind::text};

/// What --format takes, for messages.
inline constexpr std::string_view kFormatNames =
    "kitti, nuscenes, pcd, ply, text or the letters of a .bin file's numbers (xyz, xyzirt, "
    "xyzi:f64, "
    "...)";

/// "kitti", "nuscenes", "pcd", "ply", "text", or the name of another layout: "xyzi:f64".
std::string name_of(const ScanFormat& format);

/// The format of that name, as --format takes it; nothing for another word.
std::optional<ScanFormat> scan_format_named(std::string_view name);

/// What the ending of a file's name says (.pcd.bin before .bin, and .BIN as .bin); nothing for
/// hidden files and other endings, .csv and .txt among them.
std::optional<ScanFormat> format_by_name(const std::filesystem::path& path);

/// The same with .csv and .txt, which are as often something else: text.
std::optional<ScanFormat> format_by_any_name(const std::filesystem::path& path);

/// The endings of both, for messages.
inline constexpr std::string_view kScanEndings =
    ".bin, .pcd.bin, .pcd, .ply, .xyz, .pts, .csv or .txt";

/// A file's name without the ending of its format: "1532402927647951" of
/// "1532402927647951.pcd.bin".
std::string scan_stem(const std::filesystem::path& path);

}  // namespace groundgrid::io
