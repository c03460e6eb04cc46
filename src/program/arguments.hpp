#pragma once

#include <string>
#include <vector>

namespace groundgrid::program {

/// What stood on the command line after the program's name; records of a run keep it.
using Arguments = std::vector<std::string>;

}  // namespace groundgrid::program
