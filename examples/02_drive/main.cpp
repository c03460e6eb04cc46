// A drive: the map remembers what earlier scans saw. Prints, for each scan, how much of it is
// ground and how the terrain rises ahead of the vehicle.
//
//   drive [FOLDER POSES.txt]     KITTI scans (*.bin, in the order of their names) and the poses of
//                                the LiDAR, one a line: 12 numbers, [R | t] by rows. KITTI's own
//                                poses.txt has those of a camera: T_lidar = Tr^-1 * T_camera * Tr

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <groundgrid/ground_grid.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using Pose = Eigen::Isometry3d;

struct Scan {
  std::vector<float> xyzi;  // x, y, z, intensity of every point
  Pose T_map_lidar = Pose::Identity();
};

std::vector<Scan> read_drive(const std::filesystem::path& folder, const std::string& poses_file) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".bin") files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  std::vector<Scan> drive;
  std::ifstream poses(poses_file);
  for (const auto& path : files) {
    Scan& scan = drive.emplace_back();
    scan.xyzi.resize(std::filesystem::file_size(path) / sizeof(float));
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(scan.xyzi.data()),
              static_cast<std::streamsize>(scan.xyzi.size() * sizeof(float)));
    for (int i = 0; i < 12; ++i) poses >> scan.T_map_lidar(i / 4, i % 4);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    if (!poses) throw std::runtime_error(poses_file + " has no pose for " + path.string());
  }
  return drive;
}

// Ten scans of a road that climbs 5 m in 100 m, one metre between them; the LiDAR is at 1.73 m.
std::vector<Scan> synthetic_drive() {
  Scan scan;
  for (int beam = 0; beam < 64; ++beam)
    for (int step = 0; step < 2000; ++step) {
      const double down = 0.03 + 0.006 * beam, azimuth = std::numbers::pi / 1000.0 * step;
      const double distance = 1.73 / std::tan(down);
      for (const double value :
           {distance * std::cos(azimuth), distance * std::sin(azimuth), -1.73, 0.5})
        scan.xyzi.push_back(static_cast<float>(value));
    }
  std::vector<Scan> drive(10, scan);
  for (std::size_t i = 0; i < drive.size(); ++i)
    drive[i].T_map_lidar = Eigen::AngleAxisd(-std::atan(0.05), Eigen::Vector3d::UnitY()) *
                           Eigen::Translation3d(static_cast<double>(i), 0.0, 1.73);
  return drive;
}

int main(int argc, char** argv) try {
  groundgrid::GroundGrid grid;
  for (const Scan& scan : argc > 2 ? read_drive(argv[1], argv[2]) : synthetic_drive()) {
    const std::size_t points = scan.xyzi.size() / 4;
    const groundgrid::ScanResult result = grid.process(
        {groundgrid::PointView::from_floats(scan.xyzi.data(), points, 4)}, scan.T_map_lidar);

    // The poses are those of the LiDAR, and the ground is the sensor's height below it.
    const double ground_z = -result.sensor_height_m.value_or(0.0);
    const Eigen::Vector3d here = scan.T_map_lidar * Eigen::Vector3d(0.0, 0.0, ground_z);
    const Eigen::Vector3d ahead = scan.T_map_lidar * Eigen::Vector3d(10.0, 0.0, ground_z);
    const groundgrid::TerrainView terrain = grid.terrain();
    const groundgrid::TerrainCell cell =
        terrain.cell(static_cast<int>((ahead.x() - terrain.min_x_m) / terrain.resolution_m),
                     static_cast<int>((ahead.y() - terrain.min_y_m) / terrain.resolution_m));
    std::printf("%.1f %% ground; 10 m ahead the terrain is %+.2f m (confidence %.2f)\n",
                100.0 * static_cast<double>(result.ground) / static_cast<double>(points),
                cell.height - here.z(), static_cast<double>(cell.confidence));
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
