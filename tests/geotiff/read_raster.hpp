#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace groundgrid::test {

/// All of a small GeoTIFF, as GDAL reads it.
struct Raster {
  struct Band {
    std::string name;
    std::string unit;
    std::string type;  ///< "Float32".
    bool has_no_data = false;
    double no_data = 0.0;
    std::vector<float> pixels{};  ///< Row by row from the north.
  };
  int columns = 0;
  int rows = 0;
  std::array<double, 6> transform{};  ///< GDAL's: x0, dx, 0, y0, 0, dy.
  std::string epsg;                   ///< "EPSG:32632"; empty for a local frame.
  std::string area_or_point;
  std::string compression;
  std::array<int, 2> block{};
  std::vector<Band> bands{};

  [[nodiscard]] float at(int band, int column, int row) const;
};

/// Throws std::runtime_error where GDAL cannot read it.
Raster read_raster(const std::filesystem::path& path);

}  // namespace groundgrid::test
