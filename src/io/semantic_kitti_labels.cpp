#include "io/semantic_kitti_labels.hpp"

#include <fmt/format.h>

#include <bit>
#include <utility>

#include "io/error.hpp"
#include "io/input_file.hpp"

namespace groundgrid::io {

static_assert(std::endian::native == std::endian::little, "labels are read as they lie on disk");

void read_labels(const std::filesystem::path& path, const std::filesystem::path& scan,
                 std::size_t points, std::vector<std::uint32_t>& labels) {
  constexpr std::size_t kBytesPerLabel = sizeof(std::uint32_t);
  InputFile file(path);
  const auto bytes = static_cast<std::size_t>(file.size());
  if (bytes != points * kBytesPerLabel)
    throw Error({.file = path,
                 .expected = fmt::format("{} labels of {} bytes, one for each point of {}", points,
                                         kBytesPerLabel, scan.string()),
                 .got = fmt::format("{} bytes, which is {} labels", bytes, bytes / kBytesPerLabel),
                 .remedy = "the labels are cut short or belong to another scan"});
  file.read_into(labels, points);
}

void write_labels(const std::filesystem::path& path, std::span<const std::uint32_t> labels,
                  FileBatch* batch) {
  AtomicFile file(path);
  file.write(std::as_bytes(labels));
  commit(std::move(file), batch);
}

}  // namespace groundgrid::io
