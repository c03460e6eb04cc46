#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "groundgrid/config.hpp"

namespace groundgrid::program {

/// Every parameter with value, unit, range, the paper's symbol and a sentence, by stage; for the
/// terminal, no wider than 100 columns.
std::string parameter_table(const Config& config, std::string_view preset);

/// A file that --config takes and that gives `config` back over any preset that leaves out the same
/// parameters; those are commented lines.
std::string parameter_toml(const Config& config, std::string_view preset);

/// One object a parameter: name, value (null where it is left out), unit, min, max (null for
/// switches), symbol (null where the paper has none), stage, text.
nlohmann::ordered_json parameter_json(const Config& config);

/// The page docs/parameters.md, with the values of both presets.
std::string parameter_page();

}  // namespace groundgrid::program
