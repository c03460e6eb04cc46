#include "make_raster.hpp"

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <memory>
#include <stdexcept>

namespace groundgrid::test {
namespace {

void check(bool succeeded) {
  if (!succeeded) throw std::runtime_error("the raster cannot be made");
}

}  // namespace

void RasterPlan::fill(const std::function<double(double x, double y)>& value) {
  values.clear();
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      values.push_back(
          static_cast<float>(value(west + (column + 0.5) * pixel, north - (row + 0.5) * pixel)));
}

void make_raster(const std::filesystem::path& path, const RasterPlan& plan) {
  GDALRegister_GTiff();
  const std::unique_ptr<GDALDataset> raster(
      GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
          path.c_str(), plan.columns, plan.rows, 1, GDALGetDataTypeByName(plan.type.c_str()),
          nullptr));
  check(raster != nullptr);
  std::array<double, 6> transform{plan.west, plan.pixel, plan.turned, plan.north, 0.0, -plan.pixel};
  if (plan.placed) check(raster->SetGeoTransform(transform.data()) == CE_None);
  if (!plan.crs.empty()) {
    OGRSpatialReference crs;
    check(crs.SetFromUserInput(plan.crs.c_str()) == OGRERR_NONE);
    check(raster->SetSpatialRef(&crs) == CE_None);
  }
  GDALRasterBand& band = *raster->GetRasterBand(1);
  if (!plan.unit.empty()) check(band.SetUnitType(plan.unit.c_str()) == CE_None);
  if (plan.no_data) check(band.SetNoDataValue(*plan.no_data) == CE_None);
  if (plan.scale != 1.0) check(band.SetScale(plan.scale) == CE_None);
  std::vector<float> values = plan.values;
  values.resize(static_cast<std::size_t>(plan.columns) * static_cast<std::size_t>(plan.rows),
                10.0F);
  check(band.RasterIO(GF_Write, 0, 0, plan.columns, plan.rows, values.data(), plan.columns,
                      plan.rows, GDT_Float32, 0, 0, nullptr) == CE_None);
}

}  // namespace groundgrid::test
