#include "drives.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <utility>

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

testing::Scene street() {
  testing::Scene scene;
  scene.boxes = {{{-200.0, 9.0, -1.0}, {200.0, 20.0, 8.0}},
                 {{-200.0, -30.0, -1.0}, {200.0, -12.0, 6.0}},
                 {{8.0, 3.0, -1.0}, {12.0, 4.7, 1.5}},
                 {{-6.0, -5.5, -1.0}, {-1.5, -3.5, 2.2}}};
  return scene;
}

testing::SpinningSensor sensor(int beams, int azimuths, double lowest_deg, double highest_deg) {
  testing::SpinningSensor sensor;
  sensor.beams = beams;
  sensor.azimuths = azimuths;
  sensor.lowest_deg = lowest_deg;
  sensor.highest_deg = highest_deg;
  return sensor;
}

Drive simulate_drive(const testing::SpinningSensor& sensor) {
  const testing::Scene scene = street();
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

Drive simulate_128_beams() {
  const testing::SpinningSensor os1 = sensor(128, 2048, -22.5, 22.5);
  Drive drive = simulate_drive(os1);
  for (TimedScan& scan : drive.scans)
    scan.points.resize(static_cast<std::size_t>(os1.beams) *
                       static_cast<std::size_t>(os1.azimuths) * 4);
  return drive;
}

void append(const TimedScan& scan, const TimedScan& to, std::vector<float>& points) {
  const Eigen::Isometry3f T_to_scan = (to.T_map_lidar.inverse() * scan.T_map_lidar).cast<float>();
  for (std::size_t i = 0; i < scan.points.size(); i += 4) {
    const float* p = scan.points.data() + i;
    const Eigen::Vector3f moved = T_to_scan * Eigen::Vector3f(p[0], p[1], p[2]);
    points.insert(points.end(), {moved.x(), moved.y(), moved.z(), p[3]});
  }
}

Drive make_drive(Kilopoints size) {
  switch (size) {
    case k30:
      return thinned(drive(), 4);
    case k60:
      return thinned(drive(), 2);
    case k124:
      break;
    case k262:
      return simulate_128_beams();
    case k1000:
      return merged(drive(), 8);
  }
  return drive();
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
    return folder.empty() ? simulate_drive(sensor(64, 2000, -24.8, 2.0)) : read_drive(folder);
  }();
  return the_drive;
}

Drive thinned(const Drive& drive, std::size_t n) {
  Drive result = drive;
  for (TimedScan& scan : result.scans) {
    std::vector<float> points;
    for (std::size_t i = 0; i < scan.size(); i += n)
      points.insert(points.end(), scan.points.begin() + static_cast<std::ptrdiff_t>(4 * i),
                    scan.points.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
    scan.points = std::move(points);
  }
  return result;
}

Drive merged(const Drive& drive, std::size_t n) {
  Drive result = drive;
  std::vector<float> points;
  for (std::size_t i = drive.scans.size() - n; i < drive.scans.size(); ++i)
    append(drive.scans[i], drive.scans.back(), points);
  result.scans.back().points = std::move(points);
  return result;
}

const Drive& drive_of(Kilopoints size) {
  static std::map<Kilopoints, Drive> drives;
  const auto found = drives.find(size);
  return found != drives.end() ? found->second
                               : drives.emplace(size, make_drive(size)).first->second;
}

}  // namespace groundgrid::benchmarks
