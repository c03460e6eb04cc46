#pragma once

#include <string>
#include <string_view>

#include "groundgrid/parameters.hpp"

namespace groundgrid::program {

/// What may be given: "0 to 10", "true, false".
std::string range_word(const Parameter& parameter);

/// The stage of a parameter with its place in the paper: "Ground cells (III-C)".
std::string_view stage_heading(const Parameter& parameter);

/// Whether the parameter is the first one of its stage in parameters().
bool begins_stage(const Parameter& parameter);

}  // namespace groundgrid::program
