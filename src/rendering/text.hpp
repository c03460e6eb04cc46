#pragma once

#include <string>
#include <string_view>

namespace groundgrid::rendering {

/// The text with '?' for every control character and every byte that is no part of valid UTF-8.
std::string drawable(std::string_view text);

/// The text without its last character, which may be several bytes of UTF-8.
std::string without_last_character(std::string text);

}  // namespace groundgrid::rendering
