#pragma once

#include <string>
#include <vector>

namespace groundgrid::program {

/// One line `name = value` of a parameter file.
struct FileParameter {
  std::string place;  ///< "p.toml, line 3", to begin a message with.
  std::string name;   ///< As written, without quotes.
  std::string value;  ///< A string without quotes, a number in its shortest form, true or false.
};

/// Reads a parameter file: TOML in which every parameter has a line of its own, at the top level,
/// with a number, string or boolean. Throws UsageError that names file, line and parameter where a
/// line is anything else (no TOML, a table, an array, a date), io::Error where the file cannot be
/// read or is no text of some pages.
std::vector<FileParameter> read_parameter_file(const std::string& path);

}  // namespace groundgrid::program
