#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

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
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Error where not all bytes can be written (full disk).
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Closes the file and gives it its name. Throws Error where the last bytes cannot be written
  /// or the name is taken by something that is no file.
  void commit();

 private:
  friend class FileBatch;
  void close();
  [[noreturn]] void fail(int error_number) const;

  HiddenFile place_;
  std::FILE* file_ = nullptr;
};

/// Files that get their names together, since to wait for the disk takes most of the time that a
/// small file takes. Without commit(), or where it throws, those that have no name yet are removed.
class FileBatch {
 public:
  /// Takes a file once all is written to it. Commits all where they have become many. Throws Error
  /// as AtomicFile::commit() does.
  void add(AtomicFile&& file);

  void commit();

 private:
  std::vector<HiddenFile> files_;
};

/// Commits the file, or adds it to the batch where there is one.
void commit(AtomicFile&& file, FileBatch* batch);

/// Writes a whole text file. Throws Error as AtomicFile does.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace groundgrid::io
