#pragma once

#include <string_view>

namespace groundgrid::io {

/// A text without the blanks around it: spaces, tabs, and the other white space within a line.
std::string_view trimmed(std::string_view text);

/// Takes the next word, which ends at a blank, off the beginning of a line; empty at its end.
std::string_view take_word(std::string_view& line);

/// Whether a text ends so, with A to Z the same as a to z.
bool ends_with_in_any_case(std::string_view text, std::string_view ending);

}  // namespace groundgrid::io
