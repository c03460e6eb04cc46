#include "geotiff/height_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "geotiff/raster_file.hpp"
#include "io/error.hpp"

namespace groundgrid::geotiff {
namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kUsSurveyFoot_m = 1200.0 / 3937.0;

// Deeper than any land and higher than any mountain, with room for a local zero.
constexpr float kLowest_m = -1000.0F;
constexpr float kHighest_m = 9000.0F;

struct UnitName {
  std::string_view name;
  double metres;
};
constexpr std::array<UnitName, 18> kUnitNames{{{"m", 1.0},
                                               {"metre", 1.0},
                                               {"metres", 1.0},
                                               {"meter", 1.0},
                                               {"meters", 1.0},
                                               {"cm", 0.01},
                                               {"centimetre", 0.01},
                                               {"ft", kFoot_m},
                                               {"foot", kFoot_m},
                                               {"feet", kFoot_m},
                                               {"international foot", kFoot_m},
                                               {"us survey foot", kUsSurveyFoot_m},
                                               {"us survey feet", kUsSurveyFoot_m},
                                               {"us-ft", kUsSurveyFoot_m},
                                               {"ftus", kUsSurveyFoot_m},
                                               {"us_survey_foot", kUsSurveyFoot_m},
                                               {"foot_us", kUsSurveyFoot_m},
                                               {"sfoot", kUsSurveyFoot_m}}};

constexpr const char* kNameTheUnit =
    "name the unit with --reference-unit m, ft or us-ft, or convert the heights";

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

double metres_per(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::metre:
      return 1.0;
    case LengthUnit::foot:
      return kFoot_m;
    case LengthUnit::us_survey_foot:
      return kUsSurveyFoot_m;
  }
  return 1.0;
}

double metres_per_named(const std::filesystem::path& path, const std::string& name) {
  const auto* const unit =
      std::find_if(kUnitNames.begin(), kUnitNames.end(),
                   [&](const UnitName& candidate) { return candidate.name == lower_case(name); });
  if (unit == kUnitNames.end())
    throw io::Error({.file = path,
                     .expected = "heights in metres or feet",
                     .got = fmt::format("the unit {}", io::in_quotes(name)),
                     .remedy = kNameTheUnit});
  return unit->metres;
}

// Where the ground is measured in feet, heights mostly are, too, but not always.
void refuse_feet_on_the_ground(const std::filesystem::path& path, const OGRSpatialReference& crs) {
  const char* name = nullptr;
  if (crs.IsProjected() == 0 || crs.GetLinearUnits(&name) == 1.0) return;
  throw io::Error({.file = path,
                   .expected = "a raster that names the unit of its heights",
                   .got = fmt::format("none, and x and y in '{}'", name),
                   .remedy = kNameTheUnit});
}

}  // namespace

double metres_per_unit(const std::filesystem::path& path, GDALDataset& raster,
                       std::optional<LengthUnit> unit) {
  if (unit) return metres_per(*unit);
  const std::string name = raster.GetRasterBand(1)->GetUnitType();
  if (!name.empty()) return metres_per_named(path, name);
  const OGRSpatialReference* const crs = raster.GetSpatialRef();
  if (crs == nullptr) return 1.0;
  if (crs->IsVertical() != 0) return crs->GetTargetLinearUnits("VERT_CS");
  refuse_feet_on_the_ground(path, *crs);
  return 1.0;
}

void to_metres(const std::filesystem::path& path, GDALDataset& raster,
               std::optional<LengthUnit> unit, std::vector<float>& heights) {
  const double metres = metres_per_unit(path, raster, unit);
  const LinearValues values = linear_values(*raster.GetRasterBand(1));
  for (float& height : heights) {
    height =
        static_cast<float>((static_cast<double>(height) * values.scale + values.offset) * metres);
    if (std::isnan(height) || (height > kLowest_m && height < kHighest_m)) continue;
    throw io::Error({.file = path,
                     .expected = fmt::format("heights from {:g} to {:g} m", kLowest_m, kHighest_m),
                     .got = fmt::format("one of {:g} m", height),
                     .remedy = "if it stands for no height, say so with gdal_edit.py -a_nodata; if "
                               "the unit is another, with --reference-unit"});
  }
}

}  // namespace groundgrid::geotiff
