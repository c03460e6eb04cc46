#pragma once

#include <string>

namespace groundgrid::io {

/// A text as one field of a CSV table. The names of files may hold anything; RFC 4180 says how a
/// table holds them: in quotes where there are commas, quotes or line ends.
std::string csv_field(const std::string& text);

}  // namespace groundgrid::io
