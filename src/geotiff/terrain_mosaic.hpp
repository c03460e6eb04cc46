#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "geotiff/terrain_raster.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// The terrain of a whole drive as one GeoTIFF (bands as kTerrainBands says), made scan by scan.
///
/// Only the tiles under the rolling map are in memory; those that it leaves go to a hidden file
/// beside the result and come back where the drive returns, so memory does not grow with the drive.
class TerrainMosaic {
 public:
  /// `path` is the GeoTIFF to be. Throws io::Error where its folder is not writable,
  /// std::invalid_argument where PROJ does not understand the CRS.
  explicit TerrainMosaic(std::filesystem::path path, const std::string& crs = {});
  /// Without finish() nothing stays on disk.
  ~TerrainMosaic();
  TerrainMosaic(TerrainMosaic&&) noexcept;
  TerrainMosaic& operator=(TerrainMosaic&&) noexcept;
  TerrainMosaic(const TerrainMosaic&) = delete;
  TerrainMosaic& operator=(const TerrainMosaic&) = delete;

  /// Adds the map as it stands after a scan. Every view must have the same cell size; a map that
  /// started anew on another lattice (pose jump) is added at the nearest cell. Throws io::Error
  /// where the hidden file cannot be written.
  void add(const TerrainView& terrain);

  /// Writes the GeoTIFF, complete or not at all. Throws io::Error where that fails or no scan was
  /// added.
  void finish();

  /// Bytes of the tiles that are in memory now.
  [[nodiscard]] std::size_t resident_bytes() const;

 private:
  class Tiles;
  std::unique_ptr<Tiles> tiles_;
};

}  // namespace groundgrid::geotiff
