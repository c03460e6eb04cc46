#include "io/input_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::io {

namespace fs = std::filesystem;

InputFile::InputFile(fs::path path) : path_(std::move(path)) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (status.type() == fs::file_type::not_found)
    throw Error({.file = path_, .expected = "a file", .got = "nothing of that name"});
  if (fs::is_directory(status))
    throw Error({.file = path_, .expected = "a file", .got = "a directory"});
  if (!fs::is_regular_file(status))
    throw Error({.file = path_,
                 .expected = "a regular file",
                 .got = error ? error.message() : "a device, pipe or socket"});
  file_.reset(std::fopen(path_.c_str(), "rb"));
  if (!file_)
    throw Error({.file = path_, .expected = "a readable file", .got = system_message(errno)});
  size_ = fs::file_size(path_, error);
  if (error) throw Error({.file = path_, .expected = "a readable file", .got = error.message()});
}

void InputFile::read(void* destination, std::size_t bytes) {
  if (bytes == 0) return;
  const std::size_t got = std::fread(destination, 1, bytes, file_.get());
  if (got == bytes) return;
  const std::string reason = std::ferror(file_.get()) != 0
                                 ? system_message(errno)
                                 : fmt::format("{} (it became shorter while being read)", got);
  throw Error({.file = path_, .expected = fmt::format("{} bytes", bytes), .got = reason});
}

void InputFile::fail_too_large() const {
  throw Error({.file = path_,
               .expected = "a file that fits into memory",
               .got = fmt::format("{} bytes", size_)});
}

std::string read_text(const fs::path& path) {
  InputFile file(path);
  std::string text;
  file.read_into(text, static_cast<std::size_t>(file.size()));
  return text;
}

}  // namespace groundgrid::io
