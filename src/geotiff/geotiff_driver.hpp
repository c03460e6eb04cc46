#pragma once

#include <gdal_priv.h>

#include <memory>

namespace groundgrid::geotiff {

/// GDAL's GeoTIFF driver, registered where it is not yet. Only this one: the others may be plugins
/// that take long to load.
GDALDriver& geotiff_driver();

/// The same for rasters that are never a file.
GDALDriver& memory_driver();

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, CloseDataset>;

}  // namespace groundgrid::geotiff
