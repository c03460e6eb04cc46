#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <map>
#include <string>

#include "geotiff/height_raster.hpp"

namespace groundgrid::program {

/// What --reference-unit may be.
inline std::map<std::string, geotiff::LengthUnit> length_units() {
  return {{"m", geotiff::LengthUnit::metre},
          {"ft", geotiff::LengthUnit::foot},
          {"us-ft", geotiff::LengthUnit::us_survey_foot}};
}

inline void add_reference_unit(CLI::App& command, std::string& unit) {
  command
      .add_option("--reference-unit", unit,
                  "Unit of the reference: m, ft or us-ft [what the file says]")
      ->check(CLI::IsMember({"m", "ft", "us-ft"}));
}

}  // namespace groundgrid::program
