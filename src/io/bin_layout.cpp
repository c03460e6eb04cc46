#include "io/bin_layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/coordinate_fields.hpp"

namespace groundgrid::io {
namespace {

constexpr std::string_view kDoubles = ":f64";

// The field of that letter; empty if there is none.
std::string_view field_of(char letter) {
  switch (letter) {
    case 'x':
      return "x";
    case 'y':
      return "y";
    case 'z':
      return "z";
    case 'i':
      return "intensity";
    case 'r':
      return "ring";
    case 't':
      return "time";
    case '_':
      return kPaddingName;
    default:
      return "";
  }
}

}  // namespace

std::optional<BinLayout> BinLayout::named(std::string_view name) {
  const bool doubles = name.ends_with(kDoubles);
  if (doubles) name.remove_suffix(kDoubles.size());
  if (name.size() > kMostNumbers) return std::nullopt;
  for (const char letter : name)
    if (field_of(letter).empty() ||
        (letter != '_' && std::count(name.begin(), name.end(), letter) > 1))
      return std::nullopt;
  for (const char coordinate : {'x', 'y', 'z'})
    if (name.find(coordinate) == std::string_view::npos) return std::nullopt;
  return BinLayout(name, doubles ? FieldType::float64 : FieldType::float32);
}

std::string BinLayout::name() const {
  return std::string(letters_.data(), count_) +
         std::string(number_ == FieldType::float64 ? kDoubles : "");
}

std::string BinLayout::words() const {
  std::string words;
  for (std::size_t i = 0; i < count_; ++i)
    words += fmt::format("{}{}", i == 0 ? "" : " ", field_of(letters_.at(i)));
  return fmt::format("{}, {}-bit floats", words, 8 * size_of(number_));
}

void BinLayout::add_fields(PointCloud& cloud) const {
  for (std::size_t i = 0; i < count_; ++i)
    cloud.add_field(std::string(field_of(letters_.at(i))), number_);
}

}  // namespace groundgrid::io
