#include "io/hidden_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::io {

// The process number keeps two runs into one folder from writing the same hidden file.
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
  throw Error({.file = path,
               .expected = "a place to write to",
               .got = got,
               .remedy = "check the folder, its rights and the space left on the disk"});
}

}  // namespace groundgrid::io
