#include "io/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/error.hpp"

namespace groundgrid::io {

namespace fs = std::filesystem;

void require_regular_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    throw Error({.file = path, .expected = "a file", .got = "nothing of that name"});
  if (fs::is_directory(status))
    throw Error({.file = path, .expected = "a file", .got = "a directory"});
  if (!fs::is_regular_file(status))
    throw Error({.file = path,
                 .expected = "a regular file",
                 .got = error ? error.message() : "a device, pipe or socket"});
}

InputFile::InputFile(fs::path path) : path_(std::move(path)) {
  require_regular_file(path_);
  file_.reset(std::fopen(path_.c_str(), "rb"));
  if (!file_)
    throw Error({.file = path_, .expected = "a readable file", .got = system_message(errno)});
  std::error_code error;
  size_ = fs::file_size(path_, error);
  if (error) throw Error({.file = path_, .expected = "a readable file", .got = error.message()});
}

void InputFile::read(void* destination, std::size_t bytes) {
  if (bytes == 0) return;
  const std::size_t got = std::fread(destination, 1, bytes, file_.get());
  position_ += got;
  if (got == bytes) return;
  const std::string reason = std::ferror(file_.get()) != 0
                                 ? system_message(errno)
                                 : fmt::format("{} (it became shorter while being read)", got);
  throw Error({.file = path_, .expected = fmt::format("{} bytes", bytes), .got = reason});
}

std::string InputFile::peek(std::size_t bytes) {
  std::string text(static_cast<std::size_t>(std::min<std::uintmax_t>(bytes, remaining())), '\0');
  const std::uintmax_t begin = position_;
  read(text.data(), text.size());
  seek(begin);
  return text;
}

void InputFile::skip(std::uintmax_t bytes) {
  // A few bytes are read, since every seek asks the system.
  std::array<char, 256> few{};
  if (bytes <= few.size())
    read(few.data(), static_cast<std::size_t>(bytes));
  else
    seek(position_ + bytes);
}

void InputFile::seek(std::uintmax_t position) {
  position_ = position;
  if (::fseeko(file_.get(), static_cast<off_t>(position_), SEEK_SET) != 0)
    throw Error({.file = path_, .expected = "a readable file", .got = system_message(errno)});
}

std::optional<std::string> InputFile::read_line() {
  constexpr std::size_t kLongestLine = 65536;
  if (remaining() == 0) return std::nullopt;
  std::string line;
  while (remaining() > 0) {
    char letter = 0;
    read(&letter, 1);
    if (letter == '\n') break;
    if (line.size() == kLongestLine)
      throw Error({.file = path_,
                   .line = lines_ + 1,
                   .expected = fmt::format("a header's line of at most {} bytes", kLongestLine),
                   .got = "a longer one",
                   .remedy = "if the file has another format, say so with --format"});
    line += letter;
  }
  ++lines_;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
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
