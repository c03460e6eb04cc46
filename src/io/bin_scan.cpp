#include "io/bin_scan.hpp"

#include <fmt/format.h>

#include <bit>

#include "io/error.hpp"
#include "io/input_file.hpp"

namespace groundgrid::io {

static_assert(std::endian::native == std::endian::little, "scans are read as they lie on disk");

void read_bin_scan(const std::filesystem::path& path, std::vector<float>& points) {
  constexpr std::size_t kBytesPerPoint = kBinFloatsPerPoint * sizeof(float);
  InputFile file(path);
  const auto bytes = static_cast<std::size_t>(file.size());
  if (bytes % kBytesPerPoint != 0)
    throw Error({.file = path,
                 .offset = bytes - bytes % kBytesPerPoint,
                 .expected = fmt::format(
                     "whole points of {} bytes (x y z intensity as 32-bit floats)", kBytesPerPoint),
                 .got = fmt::format("{} bytes after the last whole one", bytes % kBytesPerPoint),
                 .remedy = "the file is cut short or has another layout; fetch it again"});
  file.read_into(points, bytes / sizeof(float));
}

}  // namespace groundgrid::io
