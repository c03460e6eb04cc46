#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "io/file_descriptor.hpp"

namespace groundgrid::io {

/// A file under a hidden name beside its place, to be written by us or by another library, until
/// commit() gives it its own. Without commit() the destructor removes what was written, and a file
/// that stood in the place before stays as it was.
///
/// Nobody can guess the name, and the file is new: neither a run on another machine nor a link that
/// somebody put there comes in between. As long as the object lives the file is locked (flock), by
/// which remove_leftovers() tells it from those of killed runs.
class HiddenFile {
 public:
  /// Makes the file, empty. Throws Error where the folder does not exist or is not writable.
  explicit HiddenFile(std::filesystem::path path);
  ~HiddenFile();
  HiddenFile(HiddenFile&& other) noexcept;
  HiddenFile& operator=(HiddenFile&&) = delete;
  HiddenFile(const HiddenFile&) = delete;
  HiddenFile& operator=(const HiddenFile&) = delete;

  /// The file to be.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where to write it.
  [[nodiscard]] const std::filesystem::path& hidden() const { return hidden_; }
  /// The same, open for reading and writing.
  [[nodiscard]] int descriptor() const { return descriptor_.get(); }

  /// To be called once all is written. The bytes are on the disk before the file has its name, and
  /// the name is once this returns. Throws Error where either fails, where the file is no longer
  /// under its hidden name, or its own is taken by something that is no file.
  void commit() { commit({this, 1}); }

  /// The same for many files, which takes hardly longer than for one. Where it throws, some may
  /// have their names.
  static void commit(std::span<HiddenFile> files);

  /// Has what is written so far taken to the disk without waiting for it, so that commit() will
  /// not have to wait long.
  void begin_to_synchronise() const;

 private:
  void synchronise() const;
  void rename();

  std::filesystem::path path_;
  std::filesystem::path hidden_;
  FileDescriptor descriptor_;
};

/// A file like that of a HiddenFile without any name, which is gone once it is closed. `result` is
/// the file to be: its folder holds it. Throws Error where that is not writable.
FileDescriptor file_without_name(const std::filesystem::path& result);

/// A new name as hidden files have it: .groundgrid-0123456789abcdef.tmp.
std::string hidden_name();

/// Whether hidden_name() gives such names.
bool is_hidden_name(std::string_view name);

/// What went wrong with the file to be, as an Error.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& got);

}  // namespace groundgrid::io
