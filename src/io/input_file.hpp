#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

namespace groundgrid::io {

/// Throws Error where the path is not that of a regular file, or of a link to one.
void require_regular_file(const std::filesystem::path& path);

/// A regular file opened for reading as a whole. Throws Error where the path is missing, a
/// directory or unreadable.
class InputFile {
 public:
  explicit InputFile(std::filesystem::path path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uintmax_t size() const { return size_; }

  /// Bytes from the beginning to the current position, and from there to the end.
  [[nodiscard]] std::uintmax_t position() const { return position_; }
  [[nodiscard]] std::uintmax_t remaining() const { return size_ - position_; }

  /// Lines that read_line() has given.
  [[nodiscard]] std::size_t lines() const { return lines_; }

  /// Fills `bytes` bytes from the current position. Throws Error where the file ends before.
  void read(void* destination, std::size_t bytes);

  /// The next `bytes` bytes, or fewer at the end of the file, without moving on.
  std::string peek(std::size_t bytes);

  /// Moves ahead by `bytes` bytes, of which at least that many must remain.
  void skip(std::uintmax_t bytes);

  /// The next line of a header, without its line end of either kind; nothing at the end of the
  /// file. Throws Error where it is longer than any header's line.
  std::optional<std::string> read_line();

  /// Makes `elements`, whose memory is reused, the next `count` ones as they lie on disk. Throws
  /// Error where the file ends before or memory does not hold them.
  template <typename Elements>
  void read_into(Elements& elements, std::size_t count) {
    resize(elements, count);
    read(elements.data(), count * sizeof(*elements.data()));
  }

  /// Makes room for `count` elements. Throws Error where memory does not hold them.
  template <typename Elements>
  void resize(Elements& elements, std::size_t count) const {
    try {
      elements.resize(count);
    } catch (const std::bad_alloc&) {
      fail_too_large();
    } catch (const std::length_error&) {
      fail_too_large();
    }
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void seek(std::uintmax_t position);
  [[noreturn]] void fail_too_large() const;

  std::filesystem::path path_;
  std::uintmax_t size_ = 0;
  std::uintmax_t position_ = 0;
  std::size_t lines_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The whole text of a file. Throws Error as InputFile does.
std::string read_text(const std::filesystem::path& path);

}  // namespace groundgrid::io
