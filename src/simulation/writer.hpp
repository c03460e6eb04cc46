#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/atomic_file.hpp"
#include "simulation/scanner.hpp"

namespace groundgrid::simulation {

/// The files that a SequenceWriter writes for that many scans.
std::vector<std::filesystem::path> files_of_drive(const std::filesystem::path& folder,
                                                  std::size_t scans);

/// Writes one sequence in SemanticKITTI layout, with the truth beside it:
///   velodyne/NNNNNN.bin, labels/NNNNNN.label, calib.txt, poses.txt, times.txt
///   truth/height/NNNNNN.f32   metres above the soil, of each point, 32-bit floats
///   truth/terrain.tif         height of the soil, 0.2 m cells
///   truth/vegetation.tif      1 in cells under leaves, else 0; the same cells
///   truth/kerbs.tif           1 in cells within 0.3 m of a kerb or step, else 0
/// Poses and rasters are in a frame with its origin where the sensor is at first, z up and x along
/// the vehicle: that of the first scan, unless the sensor is mounted askew.
/// Every call throws io::Error where it cannot write.
class SequenceWriter {
 public:
  /// Makes the folders and takes away what killed runs left in them. `folder` is that of the
  /// sequence.
  explicit SequenceWriter(std::filesystem::path folder);

  /// Writes the next scan, whose files have their names some scans later. Its pose goes to
  /// poses.txt as if it were known to be `T_world_sensor`.
  void add(const Scan& scan, double time_s, const Eigen::Isometry3d& T_world_sensor);

  /// Writes what is known only at the end: poses, times and rasters.
  void finish(const World& world, TileRunner& runner);

 private:
  std::filesystem::path folder_;
  std::vector<Eigen::Isometry3d> true_poses_;
  io::FileBatch scans_written_;
  std::string poses_;
  std::string times_;
  Eigen::Vector3d first_place_ = Eigen::Vector3d::Zero();  ///< Of the sensor, in the world.
};

}  // namespace groundgrid::simulation
