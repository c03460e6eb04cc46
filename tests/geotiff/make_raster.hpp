#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace groundgrid::test {

inline constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

/// A GeoTIFF to be, of one band.
struct RasterPlan {
  int columns = 4;
  int rows = 4;
  double west = 100.0;
  double north = 204.0;
  double pixel = 1.0;
  std::string crs{};   ///< "EPSG:32632"; empty for none.
  std::string unit{};  ///< Of the heights; empty for none.
  std::optional<double> no_data{};
  std::string type = "Float32";
  double scale = 1.0;
  double turned = 0.0;          ///< Second number of the geotransform.
  bool placed = true;           ///< Has a geotransform.
  std::vector<float> values{};  ///< Row by row from the north; empty: all 10.

  /// Values from the coordinates of the pixels' middles.
  void fill(const std::function<double(double x, double y)>& value);
};

void make_raster(const std::filesystem::path& path, const RasterPlan& plan);

}  // namespace groundgrid::test
