#include "drives.hpp"

#include <cstdlib>
#include <filesystem>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "support/kitti_points.hpp"
#include "support/ray_caster.hpp"

namespace groundgrid::benchmarks {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kScans = 10;
constexpr double kLidarHeight_m = 1.73;

/// The folder that holds sequences/00; empty where there is none.
fs::path dataset() {
  const char* folder = std::getenv("GROUNDGRID_DATA");  // NOLINT(concurrency-mt-unsafe)
  const fs::path data = folder != nullptr && *folder != '\0' ? folder : GROUNDGRID_DEFAULT_DATA;
  for (const fs::path& candidate : {data / "semantickitti", data})
    if (fs::is_directory(candidate / "sequences" / "00" / "velodyne")) return candidate;
  return {};
}

Drive read_drive(const fs::path& folder) {
  const std::vector<std::string> names{"00"};
  const io::ScanSequence sequence = io::find_sequences(folder, names).front();
  const io::ScanPoses poses = io::ScanPoses::kitti(sequence.poses(), sequence.calibration());
  Drive drive{"SemanticKITTI 00", {}};
  for (const io::ScanFile& file : sequence.scans) {
    if (drive.scans.size() == kScans) break;
    TimedScan& scan = drive.scans.emplace_back();
    scan.points = testing::kitti_points(file.path);
    scan.T_map_lidar = poses.pose(file);
  }
  return drive;
}

Drive simulate_drive() {
  testing::Scene scene;
  scene.boxes = {{{-200.0, 9.0, -1.0}, {200.0, 20.0, 8.0}},
                 {{-200.0, -30.0, -1.0}, {200.0, -12.0, 6.0}},
                 {{8.0, 3.0, -1.0}, {12.0, 4.7, 1.5}},
                 {{-6.0, -5.5, -1.0}, {-1.5, -3.5, 2.2}}};
  testing::SpinningSensor sensor;
  sensor.beams = 64;
  sensor.lowest_deg = -24.8;
  sensor.highest_deg = 2.0;
  sensor.azimuths = 2000;
  Drive drive{"simulated", {}};
  for (std::size_t i = 0; i < kScans; ++i) {
    TimedScan& scan = drive.scans.emplace_back();
    scan.T_map_lidar = testing::pose(0.9 * static_cast<double>(i), 0.0, kLidarHeight_m);
    const testing::SimulatedScan simulated = testing::cast_scan(
        scene, sensor, scan.T_map_lidar, Eigen::Isometry3d::Identity(), static_cast<unsigned>(i));
    for (const auto& record : simulated.records)
      scan.points.insert(scan.points.end(), {record.x, record.y, record.z, 0.0F});
  }
  return drive;
}

}  // namespace

SensorScan TimedScan::scan() const {
  SensorScan scan;
  scan.points = PointView::from_floats(points.data(), size(), 4);
  return scan;
}

const Drive& drive() {
  static const Drive the_drive = [] {
    const fs::path folder = dataset();
    return folder.empty() ? simulate_drive() : read_drive(folder);
  }();
  return the_drive;
}

}  // namespace groundgrid::benchmarks
