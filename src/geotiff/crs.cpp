#include "geotiff/crs.hpp"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <stdexcept>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/geotiff_driver.hpp"

namespace groundgrid::geotiff {
namespace {

/// GDAL puts a system for which GeoTIFF has no keys into a second file beside the raster. Whether
/// it does so only a GeoTIFF tells, here one in memory.
bool fits_into_geotiff(const OGRSpatialReference& crs) {
  const std::string name = fmt::format("/vsimem/groundgrid-crs-{}.tif", fmt::ptr(&crs));
  DatasetPtr written(geotiff_driver().Create(name.c_str(), 1, 1, 1, GDT_Byte, nullptr));
  const bool accepted = written != nullptr && written->SetSpatialRef(&crs) == CE_None;
  written.reset();
  VSIUnlink((name + ".aux.xml").c_str());
  const DatasetPtr read(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER));
  const bool fits = accepted && read != nullptr && read->GetSpatialRef() != nullptr;
  VSIUnlink(name.c_str());
  return fits;
}

}  // namespace

std::optional<OGRSpatialReference> read_crs(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const GdalErrors errors;
  OGRSpatialReference crs;
  // Without its limits the call would also open files and web addresses of that name.
  const OGRErr result = crs.SetFromUserInput(
      text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get());
  if (result != OGRERR_NONE)
    throw std::invalid_argument(fmt::format("unknown coordinate reference system '{}'{}{}", text,
                                            errors.first().empty() ? "" : ": ", errors.first()));
  if (crs.IsProjected() == 0 || crs.GetLinearUnits() != 1.0)
    throw std::invalid_argument(
        fmt::format("coordinate reference system '{}' is not projected in metres as the map is; "
                    "choose one such as UTM (EPSG:32632)",
                    text));
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (!fits_into_geotiff(crs))
    throw std::invalid_argument(fmt::format(
        "coordinate reference system '{}' is one that a GeoTIFF cannot hold; choose one such as "
        "UTM (EPSG:32632)",
        text));
  return crs;
}

}  // namespace groundgrid::geotiff
