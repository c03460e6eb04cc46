#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geotiff/surface_options.hpp"
#include "geotiff/terrain_raster.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// The terrain of a whole drive as one GeoTIFF (bands as kTerrainBands says), made scan by scan.
///
/// Only the tiles under the rolling map are in memory; those that it leaves go to a hidden file
/// beside the result and come back where the drive returns, so memory does not grow with the drive.
/// That file takes 28 bytes a cell, some 47 MB a kilometre at 0.33 m cells; it has no name, so
/// that it is gone however the process ends.
///
/// A scan tells a cell's height with the weight of its confidence there. What the map interpolated
/// has none and is not taken: gaps stay, or are filled from all the drive where a surface is asked
/// for. A cell that was seen goes on telling its height while its confidence decays, so the scans
/// that saw it outweigh those that did not.
class TerrainMosaic {
 public:
  /// `path` is the GeoTIFF to be. Throws io::Error where its folder is not writable,
  /// std::invalid_argument where the CRS is not one that write_terrain() takes.
  explicit TerrainMosaic(std::filesystem::path path, const std::string& crs = {},
                         const std::optional<SurfaceOptions>& surface = {});
  /// Without finish() nothing stays on disk.
  ~TerrainMosaic();
  TerrainMosaic(TerrainMosaic&&) noexcept;
  TerrainMosaic& operator=(TerrainMosaic&&) noexcept;
  TerrainMosaic(const TerrainMosaic&) = delete;
  TerrainMosaic& operator=(const TerrainMosaic&) = delete;

  /// Adds the map as it stands after a scan. Every view must have the same cell size; a map that
  /// started anew on another lattice (reset) is added at the nearest cell; a view without cells
  /// adds nothing. Throws io::Error where the hidden file cannot be written, std::invalid_argument
  /// where the view does not fit the ones before.
  void add(const TerrainView& terrain);

  /// Writes the GeoTIFF, complete or not at all, cropped to the cells that have a height or a
  /// density. Areas without any take no room in it. Throws io::Error where that fails, no scan told
  /// a height, or the drive spans more than a raster can hold. The mosaic stays as it is and may
  /// grow further.
  void finish();

  /// Whether no cell of any scan added had a confidence above 0, so that finish() throws.
  [[nodiscard]] bool empty() const;

  /// Bytes of the tiles that are in memory now.
  [[nodiscard]] std::size_t resident_bytes() const;

 private:
  class Tiles;
  std::unique_ptr<Tiles> tiles_;
};

}  // namespace groundgrid::geotiff
