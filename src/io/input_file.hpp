#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace groundgrid::io {

/// A regular file opened for reading as a whole. Throws Error where the path is missing, a
/// directory or unreadable.
class InputFile {
 public:
  explicit InputFile(std::filesystem::path path);

  [[nodiscard]] std::uintmax_t size() const { return size_; }

  /// Fills `bytes` bytes from the current position. Throws Error where the file ends before.
  void read(void* destination, std::size_t bytes);

  /// Makes `elements`, whose memory is reused, the next `count` ones as they lie on disk. Throws
  /// Error where the file ends before or memory does not hold them.
  template <typename Elements>
  void read_into(Elements& elements, std::size_t count) {
    try {
      elements.resize(count);
    } catch (const std::bad_alloc&) {
      fail_too_large();
    } catch (const std::length_error&) {
      fail_too_large();
    }
    read(elements.data(), count * sizeof(*elements.data()));
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  [[noreturn]] void fail_too_large() const;

  std::filesystem::path path_;
  std::uintmax_t size_ = 0;
  std::unique_ptr<std::FILE, Close> file_;
};

/// The whole text of a file. Throws Error as InputFile does.
std::string read_text(const std::filesystem::path& path);

}  // namespace groundgrid::io
