#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "evaluation/cell_lattice.hpp"
#include "geotiff/height_raster.hpp"

namespace groundgrid::program {

/// Where the vehicle was at each pose of a file (KITTI or TUM form); with a calibration the poses
/// are the camera's, as those of a KITTI dataset. Throws io::Error where a file cannot be read.
std::vector<Eigen::Vector3d> read_path(const std::filesystem::path& poses,
                                       const std::optional<std::filesystem::path>& calibration);

/// Distance of each pixel from the path of the vehicle, metres. The poses are as in
/// read_path(), in the frame of the raster. Throws io::Error where a file cannot be read or no pose
/// lies on the raster.
std::vector<float> distance_from_path(const std::filesystem::path& poses,
                                      const std::optional<std::filesystem::path>& calibration,
                                      const geotiff::RasterFrame& frame,
                                      const evaluation::CellLattice& lattice);

}  // namespace groundgrid::program
