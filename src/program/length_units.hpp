#pragma once

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

}  // namespace groundgrid::program
