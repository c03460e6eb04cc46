#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "program/version.hpp"

namespace groundgrid::program {

/// What each result begins with.
inline nlohmann::ordered_json json_heading(const char* command) {
  return {{"program", "groundgrid"}, {"version", version()}, {"command", command}};
}

/// JSON as it is printed and written; bytes of file names that are no UTF-8 are replaced.
inline std::string to_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace groundgrid::program
