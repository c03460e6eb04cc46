#include "io/true_heights.hpp"

#include <fmt/format.h>

#include <bit>

#include "io/error.hpp"
#include "io/input_file.hpp"

namespace groundgrid::io {

static_assert(std::endian::native == std::endian::little, "heights are read as they lie on disk");

void read_true_heights(const std::filesystem::path& path, const std::filesystem::path& scan,
                       std::size_t points, std::vector<float>& heights) {
  InputFile file(path);
  const auto bytes = static_cast<std::size_t>(file.size());
  if (bytes != points * sizeof(float))
    throw Error({.file = path,
                 .expected = fmt::format("{} heights of {} bytes, one for each point of {}", points,
                                         sizeof(float), scan.string()),
                 .got = fmt::format("{} bytes", bytes),
                 .remedy = "simulate the drive again, or take the folder truth/height away"});
  file.read_into(heights, points);
}

}  // namespace groundgrid::io
