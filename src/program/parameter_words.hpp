#pragma once

#include <string>
#include <string_view>

#include "groundgrid/parameters.hpp"

namespace groundgrid::program {

/// A number as short as it can be written without loss: "0.33", "5e-5", "1e6".
std::string number_word(double number);

/// The value that a parameter has: "0.33", "5", "true", "none".
std::string value_word(const Config& config, const Parameter& parameter);

/// What may be given: "0 to 10", "true, false".
std::string range_word(const Parameter& parameter);

/// Whether it may be left out: "none" is a value of it too.
bool is_optional(const Parameter& parameter);

/// The stage of a parameter with its place in the paper: "Ground cells (III-C)".
std::string_view stage_heading(const Parameter& parameter);

/// Whether the parameter is the first one of its stage in parameters().
bool begins_stage(const Parameter& parameter);

}  // namespace groundgrid::program
