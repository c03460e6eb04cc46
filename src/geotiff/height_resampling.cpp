#include <fmt/format.h>

#include "geotiff/height_raster.hpp"
#include "geotiff/height_values.hpp"
#include "geotiff/raster_file.hpp"
#include "geotiff/raster_warp.hpp"

namespace groundgrid::geotiff {
namespace {

std::vector<std::string> remarks_on(const std::filesystem::path& path, const RasterFrame& own,
                                    const RasterFrame& onto) {
  if (own.crs.empty() == onto.crs.empty()) return {};
  if (own.crs.empty())
    return {fmt::format("{} names no reference system; it is taken to be in the terrain's",
                        path.string())};
  return {fmt::format("the terrain names no reference system; it is taken to be in that of {}",
                      path.string())};
}

}  // namespace

ResampledHeights resample_heights(const std::filesystem::path& path, const RasterFrame& onto,
                                  std::optional<LengthUnit> unit) {
  const DatasetPtr raster = open_raster(path);
  (void)metres_per_unit(path, *raster, unit);  // Before the long work.
  ResampledHeights result{.heights_m = warp_band(path, *raster, onto, Resampling::smooth),
                          .remarks = remarks_on(path, frame_of(*raster), onto)};
  to_metres(path, *raster, unit, result.heights_m);
  return result;
}

std::vector<float> resample_mask(const std::filesystem::path& path, const RasterFrame& onto) {
  const DatasetPtr raster = open_raster(path);
  return warp_band(path, *raster, onto, Resampling::nearest);
}

}  // namespace groundgrid::geotiff
