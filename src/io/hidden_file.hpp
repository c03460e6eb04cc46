#pragma once

#include <filesystem>
#include <string>

namespace groundgrid::io {

/// The hidden name beside its place under which a file is written, by us or by another library,
/// until commit() gives it its own. Without commit() the destructor removes what was written, and
/// a file that stood in the place before stays as it was.
class HiddenFile {
 public:
  explicit HiddenFile(std::filesystem::path path);
  ~HiddenFile();
  HiddenFile(const HiddenFile&) = delete;
  HiddenFile& operator=(const HiddenFile&) = delete;
  HiddenFile(HiddenFile&&) = delete;
  HiddenFile& operator=(HiddenFile&&) = delete;

  /// The file to be.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where to write it.
  [[nodiscard]] const std::filesystem::path& hidden() const { return hidden_; }

  /// To be called once the file is closed. Throws Error where the name is taken by something that
  /// is no file.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path hidden_;
};

/// What went wrong with the file to be, as an Error.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& got);

}  // namespace groundgrid::io
