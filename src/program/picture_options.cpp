#include "program/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/path_checks.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

// Smaller ones have no room for their words, larger ones take gigabytes of memory to draw.
constexpr int kLeastWidth = 240;
constexpr int kLeastHeight = 180;
constexpr int kGreatestSide = 8000;
constexpr std::size_t kMostPixels = 16'000'000;

std::optional<int> pixels_in(std::string_view text) {
  int pixels = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return pixels;
}

bool is_allowed(rendering::ImageSize size) {
  return size.width >= kLeastWidth && size.height >= kLeastHeight && size.width <= kGreatestSide &&
         size.height <= kGreatestSide && size.pixels() <= kMostPixels;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

}  // namespace

void PictureOptions::add_to(CLI::App& command, const std::string& ending,
                            const std::string& usual_size) {
  ending_ = ending;
  command.add_option("--output", output_, fmt::format("The picture to write (*{})", ending))
      ->required();
  command.add_option("--size", size_, fmt::format("Width and height in pixels [{}]", usual_size))
      ->type_name("WxH");
  title_option_ = command.add_option("--title", title_, "Another title; \"\" for none");
}

void PictureOptions::check() const {
  if (lower_case(output_.extension().string()) != ending_)
    throw UsageError(fmt::format("--output: expected a file that ends in {}, got '{}'", ending_,
                                 output_.string()));
  (void)size_or({});
  if (io::is_folder(output_)) io::fail_to_write(output_, "a folder of that name");
  // Made and removed again: what cannot be written shows before the work is done.
  const io::AtomicFile trial(output_);
}

rendering::ImageSize PictureOptions::size_or(rendering::ImageSize usual) const {
  if (size_.empty()) return usual;
  const std::size_t sign = size_.find('x');
  if (sign != std::string::npos) {
    const auto width = pixels_in(std::string_view(size_).substr(0, sign));
    const auto height = pixels_in(std::string_view(size_).substr(sign + 1));
    if (width && height && is_allowed({*width, *height})) return {*width, *height};
  }
  throw UsageError(
      fmt::format("--size: expected WxH from {}x{} to {} a side and {} million pixels, got '{}'",
                  kLeastWidth, kLeastHeight, kGreatestSide, kMostPixels / 1'000'000, size_));
}

std::string PictureOptions::title_or(const std::string& usual) const {
  return title_option_->count() > 0 ? title_ : usual;
}

}  // namespace groundgrid::program
