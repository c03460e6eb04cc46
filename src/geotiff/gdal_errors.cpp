#include "geotiff/gdal_errors.hpp"

#include <cpl_error.h>

namespace groundgrid::geotiff {
namespace {

void keep_first(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  auto& first = *static_cast<std::string*>(CPLGetErrorHandlerUserData());
  if (severity >= CE_Failure && first.empty()) first = message;
}

}  // namespace

GdalErrors::GdalErrors() { CPLPushErrorHandlerEx(keep_first, &first_); }
GdalErrors::~GdalErrors() { CPLPopErrorHandler(); }

}  // namespace groundgrid::geotiff
