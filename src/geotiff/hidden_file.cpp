#include "geotiff/hidden_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::geotiff {

HiddenFile::HiddenFile(std::filesystem::path path)
    : path_(std::move(path)),
      hidden_(path_.parent_path() /
              fmt::format(".{}.{}.tmp", path_.filename().string(), ::getpid())) {}

HiddenFile::~HiddenFile() {
  if (hidden_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove(hidden_, ignored);
}

void HiddenFile::commit() {
  std::error_code error;
  std::filesystem::rename(hidden_, path_, error);
  if (error) fail_to_write(path_, error.message());
  hidden_.clear();
}

void fail_to_write(const std::filesystem::path& path, const std::string& got) {
  throw io::Error({.file = path,
                   .expected = "a place to write to",
                   .got = got,
                   .remedy = "check the folder, its rights and the space left on the disk"});
}

void fail_without_terrain(const std::filesystem::path& path) {
  throw io::Error({.file = path,
                   .expected = "terrain to write",
                   .got = "a map in which no scan has shown any ground"});
}

}  // namespace groundgrid::geotiff
