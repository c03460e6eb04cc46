#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <vector>

#include "geotiff/height_raster.hpp"
#include "program/input_files.hpp"
#include "rendering/map_picture.hpp"

namespace groundgrid::program {

/// The flags that say where the vehicle drove.
class PathOptions {
 public:
  /// The object must stay where it is until parsing is over.
  void add_to(CLI::App& command);

  /// The files that are named.
  void add_files(InputFiles& inputs) const;

  /// The path in the frame of the terrain; empty where none is asked for. Throws io::Error where
  /// it cannot be read or no pose of it lies on the map.
  [[nodiscard]] std::vector<rendering::MapPoint> read(const rendering::HeightGrid& map) const;

 private:
  std::filesystem::path poses_;
  std::filesystem::path calibration_;
};

/// Heights in a raster's pixels, turned so that the first is in the north-west.
rendering::HeightGrid grid_of(const geotiff::RasterFrame& frame, std::vector<float> heights_m);

/// "120 m x 80 m, cells of 0.33 m".
std::string extent_words(const rendering::HeightGrid& grid);

}  // namespace groundgrid::program
