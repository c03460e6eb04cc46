#include "support/drive.hpp"

#include <cstring>
#include <string>

namespace groundgrid::testing {
namespace {

Scene street() {
  Scene scene;
  scene.boxes = {
      {{-200.0, 9.0, -1.0}, {200.0, 20.0, 8.0}, false},     // houses on the left
      {{-200.0, -30.0, -1.0}, {200.0, -12.0, 6.0}, false},  // and on the right
      {{-200.0, 5.0, -1.0}, {200.0, 9.0, 0.12}, true},      // pavement behind a kerb
      {{8.0, 2.9, -1.0}, {12.2, 4.7, 1.5}, false},          // parked cars
      {{15.0, 2.9, -1.0}, {19.2, 4.7, 1.5}, false},
      {{-6.0, -5.5, -1.0}, {-1.5, -3.5, 2.2}, false},
      {{25.0, -1.0, -1.0}, {25.5, -0.5, 1.8}, false},  // a pedestrian
  };
  return scene;
}

template <typename T>
bool equal_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool equal_statistics(const std::vector<CellStatistics>& a, const std::vector<CellStatistics>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const CellStatistics& p, const CellStatistics& q) {
                      return p.sum == q.sum && p.sum_squares == q.sum_squares && p.min == q.min &&
                             p.max == q.max && p.count == q.count;
                    });
}

::testing::AssertionResult all_of(std::initializer_list<std::pair<const char*, bool>> equal) {
  std::string differing;
  for (const auto& [name, is_equal] : equal)
    if (!is_equal) differing += std::string(differing.empty() ? "" : ", ") + name;
  if (differing.empty()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "these differ: " << differing;
}

}  // namespace

SensorScan DriveScan::scan() const {
  SensorScan scan;
  scan.points = PointView::from_floats(points.data(), size(), floats_per_point);
  if (T_base_sensor) scan.T_base_sensor = *T_base_sensor;
  return scan;
}

std::vector<DriveScan> street_drive(int scans, const SpinningSensor& sensor) {
  std::vector<DriveScan> drive;
  const Scene scene = street();
  for (int i = 0; i < scans; ++i) {
    DriveScan& scan = drive.emplace_back();
    scan.T_map_base = pose(0.75 * i, 0.125 * i, 1.75);
    scan.points = cast_scan(scene, sensor, scan.T_map_base, Eigen::Isometry3d::Identity(),
                            static_cast<unsigned>(i))
                      .packed();
  }
  return drive;
}

DriveResult run_drive(GroundGrid& grid, const std::vector<DriveScan>& drive) {
  DriveResult all;
  for (const DriveScan& scan : drive) {
    const ScanResult result = grid.process(scan.scan(), scan.T_map_base);
    all.labels.insert(all.labels.end(), result.labels.begin(), result.labels.end());
    all.height_above_ground.insert(all.height_above_ground.end(),
                                   result.height_above_ground.begin(),
                                   result.height_above_ground.end());
  }
  const TerrainView terrain = grid.terrain();
  all.terrain_height.assign(terrain.relative_height.begin(), terrain.relative_height.end());
  all.terrain_confidence.assign(terrain.confidence.begin(), terrain.confidence.end());
  const std::span<const CellStatistics> statistics = statistics_of(terrain);
  all.terrain_statistics.assign(statistics.begin(), statistics.end());
  return all;
}

DriveResult run_drive(const Config& config, const std::vector<DriveScan>& drive, int threads) {
  GroundGrid grid(config, threads);
  return run_drive(grid, drive);
}

::testing::AssertionResult same_bits(const DriveResult& a, const DriveResult& b) {
  return all_of(
      {{"labels", equal_bits(a.labels, b.labels)},
       {"height_above_ground", equal_bits(a.height_above_ground, b.height_above_ground)},
       {"terrain height", equal_bits(a.terrain_height, b.terrain_height)},
       {"terrain confidence", equal_bits(a.terrain_confidence, b.terrain_confidence)},
       {"terrain statistics", equal_statistics(a.terrain_statistics, b.terrain_statistics)}});
}

::testing::AssertionResult same_answers(const DriveResult& a, const DriveResult& b) {
  return all_of(
      {{"labels", equal_bits(a.labels, b.labels)},
       {"height_above_ground", equal_bits(a.height_above_ground, b.height_above_ground)}});
}

double share_different(const std::vector<Label>& a, const std::vector<Label>& b) {
  if (a.size() != b.size() || a.empty()) return 1.0;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) ++different;
  return static_cast<double>(different) / static_cast<double>(a.size());
}

}  // namespace groundgrid::testing
