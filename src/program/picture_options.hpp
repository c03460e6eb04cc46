#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "rendering/image.hpp"

namespace groundgrid::program {

/// The flags that every picture has: --output, --size, --title.
class PictureOptions {
 public:
  /// `ending` is that of the file, with its dot. The object must stay where it is until parsing is
  /// over.
  void add_to(CLI::App& command, const std::string& ending, rendering::ImageSize usual);

  /// Throws UsageError where the file has another ending or the size is none, io::Error where the
  /// file cannot be written. To be called before the work begins.
  void check() const;

  [[nodiscard]] const std::filesystem::path& output() const { return output_; }
  [[nodiscard]] bool has_size() const { return !size_.empty(); }
  /// As asked for, else the usual one. Throws UsageError.
  [[nodiscard]] rendering::ImageSize size() const;
  /// As asked for, else `usual`.
  [[nodiscard]] std::string title_or(const std::string& usual) const;

 private:
  std::filesystem::path output_;
  std::string ending_;
  std::string size_;
  rendering::ImageSize usual_{};
  std::string title_;
  CLI::Option* title_option_ = nullptr;
};

}  // namespace groundgrid::program
