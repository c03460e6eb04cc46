#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <utility>

namespace groundgrid::io {

/// A number of the system's for an open file or folder, which is closed with the object.
class FileDescriptor {
 public:
  /// Nothing is open where the number is negative, as that of a failed open() is.
  explicit FileDescriptor(int number = -1) : number_(number) {}
  /// What the system's open() gives; a new file has the rights that the umask leaves it.
  static FileDescriptor open(const std::filesystem::path& path, int flags) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system has no other
    return FileDescriptor(::open(path.c_str(), flags | O_CLOEXEC, 0666));
  }
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

}  // namespace groundgrid::io
