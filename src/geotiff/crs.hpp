#pragma once

#include <ogr_spatialref.h>

#include <optional>
#include <string>

namespace groundgrid::geotiff {

/// The coordinate reference system of the map frame; nothing for a local frame, whose text is
/// empty. Throws std::invalid_argument, naming the text, where PROJ does not understand it, its x
/// and y are not metres, or a GeoTIFF cannot hold it.
std::optional<OGRSpatialReference> read_crs(const std::string& text);

}  // namespace groundgrid::geotiff
