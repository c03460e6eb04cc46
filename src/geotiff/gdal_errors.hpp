#pragma once

#include <string>

namespace groundgrid::geotiff {

/// While one lives, what GDAL and PROJ report on this thread comes here instead of to standard
/// error. Must end on the thread that it began on.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;
  GdalErrors(GdalErrors&&) = delete;
  GdalErrors& operator=(GdalErrors&&) = delete;

  /// The first failure: what follows it is mostly its consequence. Empty where there was none.
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  std::string first_;
};

}  // namespace groundgrid::geotiff
