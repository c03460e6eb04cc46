#pragma once

#include <filesystem>
#include <string>

namespace groundgrid::geotiff {

/// The hidden name beside its place under which another library writes a file, until commit()
/// gives it its own. Without commit() the destructor removes what was written.
class HiddenFile {
 public:
  explicit HiddenFile(std::filesystem::path path);
  ~HiddenFile();
  HiddenFile(const HiddenFile&) = delete;
  HiddenFile& operator=(const HiddenFile&) = delete;
  HiddenFile(HiddenFile&&) = delete;
  HiddenFile& operator=(HiddenFile&&) = delete;

  [[nodiscard]] const std::filesystem::path& hidden() const { return hidden_; }

  /// Throws io::Error where the name is taken by something that is no file.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path hidden_;
};

/// What went wrong with the file to be, as an io::Error.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& got);

/// An io::Error for a file to be that would hold no cell.
[[noreturn]] void fail_without_terrain(const std::filesystem::path& path);

}  // namespace groundgrid::geotiff
