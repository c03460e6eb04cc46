#pragma once

#include <string>
#include <vector>

namespace groundgrid::program {

/// One line `name = value` of a parameter file.
struct FileParameter {
  std::string place;  ///< "p.toml, line 3", to begin a message with.
  std::string name;   ///< As written.
  std::string value;  ///< Without quotes.
};

/// Reads a parameter file: the part of TOML that parameters need, which is comments and lines of
/// one plain or quoted value. Throws UsageError that names file, line and parameter where a line is
/// anything else (a table, an array, a quote left open), io::Error where the file cannot be read.
std::vector<FileParameter> read_parameter_file(const std::string& path);

}  // namespace groundgrid::program
