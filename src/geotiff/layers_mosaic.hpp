#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "groundgrid/terrain_layers.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// The bands of a raster of terrain layers, all 32-bit floats, kNoData where they say nothing.
///  1 slope: degrees
///  2 step: metres
///  3 roughness: metres
///  4 obstacle_height: metres above the ground, 0 where there is no obstacle
///  5 traversability: 1 yes, 0 no; no data where it is unknown
inline constexpr int kLayerBands = 5;

/// The terrain layers of a whole drive as one GeoTIFF (bands as kLayerBands says), made scan by
/// scan as TerrainMosaic is. Slope, step and roughness are those of the scan after which the cell
/// had its greatest confidence, the obstacle height that of the last scan that saw the cell, so
/// that who has driven off leaves none behind; traversability follows from both.
class LayersMosaic {
 public:
  /// `path` is the GeoTIFF to be. Throws io::Error where its folder is not writable,
  /// std::invalid_argument where a limit is wrong or the CRS is not one that write_terrain() takes.
  LayersMosaic(std::filesystem::path path, const TraversabilityLimits& limits,
               const std::string& crs = {});
  /// Without finish() nothing stays on disk.
  ~LayersMosaic();
  LayersMosaic(LayersMosaic&&) noexcept;
  LayersMosaic& operator=(LayersMosaic&&) noexcept;
  LayersMosaic(const LayersMosaic&) = delete;
  LayersMosaic& operator=(const LayersMosaic&) = delete;

  /// Adds the layers of the map as it stands after a scan. Throws as TerrainMosaic::add() does, and
  /// std::invalid_argument where layers and view are not of the same size.
  void add(const TerrainView& terrain, const TerrainLayers& layers);

  /// Writes the GeoTIFF, complete or not at all, cropped to the cells that have a layer. Throws
  /// io::Error where that fails or no cell has one.
  void finish();

  /// Whether no cell has a layer, so that finish() throws.
  [[nodiscard]] bool empty() const;

 private:
  class Tiles;
  std::unique_ptr<Tiles> tiles_;
};

}  // namespace groundgrid::geotiff
