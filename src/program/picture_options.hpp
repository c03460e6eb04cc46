#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "rendering/image.hpp"

namespace groundgrid::program {

/// The flags that every picture has: --output, --size, --title.
class PictureOptions {
 public:
  /// `ending` is that of the file, with its dot; `usual_size` says what holds without --size. The
  /// object must stay where it is until parsing is over.
  void add_to(CLI::App& command, const std::string& ending, const std::string& usual_size);

  /// Throws UsageError where the file has another ending or the size is none, io::Error where the
  /// file cannot be written. To be called before the work begins.
  void check() const;

  [[nodiscard]] const std::filesystem::path& output() const { return output_; }
  /// As asked for, else `usual`. Throws UsageError.
  [[nodiscard]] rendering::ImageSize size_or(rendering::ImageSize usual) const;
  /// As asked for, else `usual`.
  [[nodiscard]] std::string title_or(const std::string& usual) const;

 private:
  std::filesystem::path output_;
  std::string ending_;
  std::string size_;
  std::string title_;
  CLI::Option* title_option_ = nullptr;
};

}  // namespace groundgrid::program
