#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "evaluation/cell_lattice.hpp"
#include "geotiff/height_raster.hpp"

namespace groundgrid::program {

/// Distance of each pixel from the path of the vehicle, metres. The poses of the file (KITTI or TUM
/// form) are in the frame of the raster; with a calibration they are the camera's, as those of a
/// KITTI dataset. Throws io::Error where a file cannot be read or no pose lies on the raster.
std::vector<float> distance_from_path(const std::filesystem::path& poses,
                                      const std::optional<std::filesystem::path>& calibration,
                                      const geotiff::RasterFrame& frame,
                                      const evaluation::CellLattice& lattice);

}  // namespace groundgrid::program
