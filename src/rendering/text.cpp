#include "rendering/text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace groundgrid::rendering {
namespace {

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

std::size_t length_by_first(unsigned char first) {
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return 2;
  if (first >= 0xE0U && first <= 0xEFU) return 3;
  if (first >= 0xF0U && first <= 0xF4U) return 4;
  return 0;
}

bool is_scalar(std::uint32_t code, std::size_t length) {
  constexpr std::uint32_t kLeastOfThree = 0x800U;
  constexpr std::uint32_t kLeastOfFour = 0x10000U;
  if (length == 3) return code >= kLeastOfThree && (code < 0xD800U || code > 0xDFFFU);
  return length != 4 || (code >= kLeastOfFour && code <= 0x10FFFFU);
}

// Bytes of the character that the text begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = length_by_first(first);
  if (length == 0 || length > text.size()) return 0;
  if (length == 1) return first >= 0x20U && first != 0x7FU ? 1 : 0;
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return 0;
    code = code << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  return is_scalar(code, length) ? length : 0;
}

}  // namespace

std::string drawable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    result += length == 0 ? "?" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string without_last_character(std::string text) {
  while (!text.empty() && continues(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace groundgrid::rendering
