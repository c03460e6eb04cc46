// Where the map frame's origin lies and where its axes point must not matter.
#include <gtest/gtest.h>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"
#include "support/real_data.hpp"

namespace groundgrid {
namespace {

using testing::DriveScan;
using testing::run_drive;
using testing::same_answers;
using testing::share_different;
using testing::street_drive;

std::vector<DriveScan> transformed(std::vector<DriveScan> drive,
                                   const Eigen::Isometry3d& T_new_map) {
  for (DriveScan& scan : drive) scan.T_map_base = T_new_map * scan.T_map_base;
  return drive;
}

std::vector<DriveScan> moved(std::vector<DriveScan> drive, const Eigen::Vector3d& by) {
  for (DriveScan& scan : drive) scan.T_map_base.translation() += by;
  return drive;
}

std::vector<DriveScan> real_drive(const std::filesystem::path& dataset) {
  std::vector<DriveScan> drive;
  for (testing::RealScan& real : testing::read_scans(dataset, "00", 4))
    drive.push_back({std::move(real.points), 4, real.T_map_lidar, std::nullopt});
  return drive;
}

/// The same drive with the vehicle pitched and rolled on its springs.
std::vector<DriveScan> rocking(std::vector<DriveScan> drive) {
  for (std::size_t i = 0; i < drive.size(); ++i)
    drive[i].T_map_base.rotate(
        Eigen::AngleAxisd(0.002 * static_cast<double>(i), Eigen::Vector3d(0.6, 0.8, 0.0)));
  return drive;
}

const Eigen::Vector3d kExact(512.0, -1024.0, 64.0);
const Eigen::Vector3d kUtm(461234.567, 5438765.432, 312.89);

TEST(Frame, AnExactMoveGivesTheSameBits) {
  for (Config config : {Config{}, Config::paper()}) {
    // 1.75 and the estimate have few mantissa bits, 1.73 has all of them.
    for (const std::optional<double> height :
         {std::optional<double>{}, std::optional(1.75), std::optional(1.73)}) {
      config.vehicle.sensor_height_m = height;
      const std::vector<DriveScan> drive = street_drive(4);
      EXPECT_TRUE(same_answers(run_drive(config, drive), run_drive(config, moved(drive, kExact))))
          << "sensor height " << height.value_or(0.0);
    }
  }
}

TEST(Frame, AnExactMoveOfARockingVehicleGivesTheSameBits) {
  const std::vector<DriveScan> drive = rocking(street_drive(4));
  EXPECT_TRUE(same_answers(run_drive(Config{}, drive), run_drive(Config{}, moved(drive, kExact))));
}

TEST(Frame, AMoveToUtmChangesHardlyALabel) {
  for (const Config& config : {Config{}, Config::paper()}) {
    const std::vector<DriveScan> drive = rocking(street_drive(6));
    EXPECT_LE(share_different(run_drive(config, drive).labels,
                              run_drive(config, moved(drive, kUtm)).labels),
              1e-4);
  }
}

TEST(Frame, AMoveToUtmChangesHardlyALabelOfRealScans) {
  GROUNDGRID_NEEDS_DATA(dataset)
  const std::vector<DriveScan> drive = real_drive(*dataset);
  EXPECT_LE(share_different(run_drive(Config{}, drive).labels,
                            run_drive(Config{}, moved(drive, kUtm)).labels),
            1e-4);
}

TEST(Frame, AQuarterTurnChangesHardlyALabel) {
  const Eigen::Isometry3d turn = testing::pose(0.0, 0.0, 0.0, 90.0);
  for (const Config& config : {Config{}, Config::paper()}) {
    const std::vector<DriveScan> drive = street_drive(6);
    EXPECT_LE(share_different(run_drive(config, drive).labels,
                              run_drive(config, transformed(drive, turn)).labels),
              1e-3);
  }
}

TEST(Frame, AQuarterTurnChangesHardlyALabelOfRealScans) {
  GROUNDGRID_NEEDS_DATA(dataset)
  const std::vector<DriveScan> drive = real_drive(*dataset);
  const Eigen::Isometry3d turn = testing::pose(0.0, 0.0, 0.0, 90.0);
  EXPECT_LE(share_different(run_drive(Config{}, drive).labels,
                            run_drive(Config{}, transformed(drive, turn)).labels),
            1e-3);
}

TEST(Frame, TheTerrainComesOutInTheMapFrame) {
  const std::vector<DriveScan> drive = moved(street_drive(2), kUtm);
  GroundGrid grid;
  run_drive(grid, drive);
  const TerrainView terrain = grid.terrain();
  const Eigen::Vector3d sensor = drive.back().T_map_base.translation();
  // Three metres ahead of the sensor there is road, 1.75 m below it.
  const int column = static_cast<int>((sensor.x() + 3.0 - terrain.min_x_m) / terrain.resolution_m);
  const int row = static_cast<int>((sensor.y() - 1.5 - terrain.min_y_m) / terrain.resolution_m);
  EXPECT_NEAR(terrain.cell(column, row).height, kUtm.z(), 0.05);
}

}  // namespace
}  // namespace groundgrid
