#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geotiff/surface_options.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// Value of a band in cells of which no scan said anything for it.
inline constexpr float kNoData = -9999.0F;

/// The bands of a terrain raster, all 32-bit floats.
///  1 height: metres in the map frame; over a drive the mean weighted by confidence
///  2 confidence: 0 to 1; over a drive the highest that the cell reached
///  3 count: points that fell into the cell; over a drive the sum
///  4 density: points of one scan per m² of the square of about 1 m² around the cell (3 × 3 cells
///    of 0.33 m); over a drive the greatest
///  5 standard deviation: of the height, metres, from how well planes through the heights around
///    are known and how far the height stands off them (docs/method.md)
/// Height, confidence and standard deviation are there where a scan showed ground, and where a
/// surface was asked for also in the gaps that it fills, with confidence 0; count and density also
/// where points fell into the square and none was ground.
inline constexpr int kTerrainBands = 5;

/// Throws std::invalid_argument, naming it, where a CRS cannot be that of a terrain: PROJ does not
/// understand it, its x and y are not metres, or a GeoTIFF cannot hold it. An empty one is a local
/// frame.
void check_crs(const std::string& crs);

/// Writes the map as it stands after one scan as a GeoTIFF: north-up (row 0 has the greatest y,
/// column 0 the least x), pixel = cell, DEFLATE, tiled. Bands as kTerrainBands says; a cell with
/// confidence 0 has no height unless a surface fills it.
///
/// `crs` is the system of the map frame: whatever PROJ understands ("EPSG:32632", WKT, a PROJ
/// string) if it is projected in metres, or empty for a local frame. Complete or not at all. Throws
/// io::Error where the file cannot be written or the map has not begun, std::invalid_argument
/// where the CRS is unknown, not in metres or not for GeoTIFF, or a layer of the view has not size
/// x size cells.
void write_terrain(const std::filesystem::path& path, const TerrainView& terrain,
                   const std::string& crs = {}, const std::optional<SurfaceOptions>& surface = {});

}  // namespace groundgrid::geotiff
