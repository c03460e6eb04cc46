#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "require.hpp"

namespace groundgrid::fuzz {

/// A file in memory with these bytes and a path that readers take as that of any regular file.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* bytes, std::size_t size)
      : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, "a file in memory can be made");
    const ssize_t written = ::write(descriptor_, bytes, size);
    require(written == static_cast<ssize_t>(size), "a file in memory takes all bytes");
  }
  explicit MemoryFile(const std::string& text)
      : MemoryFile(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()) {}
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

}  // namespace groundgrid::fuzz
