#include "program/terrain_path.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>

#include "evaluation/path_distance.hpp"
#include "io/calibration.hpp"
#include "io/error.hpp"
#include "io/pose_file.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

std::vector<Eigen::Isometry3d> read_poses(const fs::path& path) {
  try {
    return io::read_pose_file(path).poses;
  } catch (const io::Error& error) {
    io::ErrorDetails details = error.details();
    details.remedy = "mend the file, or leave --path out";
    throw io::Error(details);
  }
}

}  // namespace

std::vector<Eigen::Vector3d> read_path(const fs::path& poses,
                                       const std::optional<fs::path>& calibration) {
  const Eigen::Isometry3d T_camera_lidar =
      calibration ? io::read_lidar_calibration(*calibration) : Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> path;
  for (const Eigen::Isometry3d& pose : read_poses(poses))
    path.emplace_back((T_camera_lidar.inverse() * pose * T_camera_lidar).translation());
  return path;
}

std::vector<float> distance_from_path(const fs::path& poses,
                                      const std::optional<fs::path>& calibration,
                                      const geotiff::RasterFrame& frame,
                                      const evaluation::CellLattice& lattice) {
  const std::array<double, 6>& t = frame.transform;
  const std::vector<Eigen::Vector3d> path_m = read_path(poses, calibration);
  std::vector<evaluation::LatticePoint> path;
  path.reserve(path_m.size());
  for (const Eigen::Vector3d& place_m : path_m)
    path.push_back({(place_m.x() - t[0]) / t[1], (place_m.y() - t[3]) / t[5]});
  std::vector<float> distance = evaluation::path_distance(path, lattice);
  if (distance.empty())
    throw io::Error(
        {.file = poses,
         .expected = "poses on the terrain",
         .got = fmt::format("none there; the first is at x {:.1f}, y {:.1f}", path_m.front().x(),
                            path_m.front().y()),
         .remedy = "give them in the frame of the terrain; poses.txt of a KITTI dataset needs "
                   "--calibration calib.txt"});
  return distance;
}

}  // namespace groundgrid::program
