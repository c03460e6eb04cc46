#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>

#include "io/hidden_file.hpp"

namespace groundgrid::io {

/// A file that appears complete or not at all: it is written beside its place under a hidden name
/// and renamed by commit(). Without commit() the destructor removes what was written, and a file
/// that stood in the place before stays as it was.
class AtomicFile {
 public:
  /// Opens the temporary file. Throws Error where the folder does not exist or is not writable.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// Throws Error where not all bytes can be written (full disk).
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Closes the file and gives it its name. Throws Error where the last bytes cannot be written
  /// or the name is taken by something that is no file.
  void commit();

 private:
  [[noreturn]] void fail(int error_number) const;

  HiddenFile place_;
  std::FILE* file_ = nullptr;
};

/// Writes a whole text file. Throws Error as AtomicFile does.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace groundgrid::io
