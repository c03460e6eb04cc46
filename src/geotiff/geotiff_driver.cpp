#include "geotiff/geotiff_driver.hpp"

#include <gdal_frmts.h>

namespace groundgrid::geotiff {

GDALDriver& geotiff_driver() {
  [[maybe_unused]] static const bool registered = [] {
    GDALRegister_GTiff();
    return true;
  }();
  return *GetGDALDriverManager()->GetDriverByName("GTiff");
}

GDALDriver& memory_driver() {
  [[maybe_unused]] static const bool registered = [] {
    GDALRegister_MEM();
    return true;
  }();
  return *GetGDALDriverManager()->GetDriverByName("MEM");
}

}  // namespace groundgrid::geotiff
