// How points and answers lie in memory, and input that is rejected.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"

namespace groundgrid {
namespace {

using testing::DriveResult;
using testing::DriveScan;
using testing::run_drive;
using testing::same_bits;
using testing::street_drive;

/// Copies a scan into records of `stride` bytes with x, y, z at the offsets given.
struct Records {
  std::vector<std::byte> bytes;
  PointView view;

  Records(const DriveScan& scan, std::size_t stride, std::array<std::size_t, 3> offsets,
          std::size_t lead = 0)
      : bytes(lead + scan.size() * stride, std::byte{0xA5}) {
    for (std::size_t i = 0; i < scan.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::memcpy(&bytes[lead + i * stride + offsets[axis]], &scan.points[3 * i + axis],
                    sizeof(float));
    view.data = bytes.data() + lead;
    view.count = scan.size();
    view.stride_bytes = stride;
    view.x_offset = offsets[0];
    view.y_offset = offsets[1];
    view.z_offset = offsets[2];
  }
};

TEST(Input, RecordsOfAnyLayoutGiveTheSameBits) {
  const std::vector<DriveScan> drive = street_drive(2);
  const DriveResult expected = run_drive(Config{}, drive);
  struct Layout {
    std::size_t stride;
    std::array<std::size_t, 3> offsets;
    std::size_t lead;
  };
  for (const Layout& layout :
       {Layout{16, {0, 4, 8}, 0}, Layout{32, {4, 12, 20}, 0}, Layout{20, {16, 8, 0}, 0},
        Layout{15, {1, 6, 11}, 3}, Layout{12, {8, 4, 0}, 1}}) {
    GroundGrid grid;
    DriveResult result;
    for (const DriveScan& scan : drive) {
      const Records records(scan, layout.stride, layout.offsets, layout.lead);
      SensorScan sensor_scan;
      sensor_scan.points = records.view;
      const ScanResult answer = grid.process(sensor_scan, scan.T_map_base);
      result.labels.insert(result.labels.end(), answer.labels.begin(), answer.labels.end());
      result.height_above_ground.insert(result.height_above_ground.end(),
                                        answer.height_above_ground.begin(),
                                        answer.height_above_ground.end());
    }
    EXPECT_TRUE(testing::same_answers(result, expected)) << "stride " << layout.stride;
  }
}

// A quarter of an organised cloud may be rays that came back to nothing, written as zeros.
TEST(Input, PointsAtTheSensorsOriginAreNoReturns) {
  const std::vector<DriveScan> drive = street_drive(1);
  const DriveResult expected = run_drive(Config{}, drive);
  std::vector<DriveScan> with_zeros = drive;
  with_zeros[0].points.resize(with_zeros[0].points.size() + 3 * 500, 0.0F);
  const DriveResult result = run_drive(Config{}, with_zeros);
  const std::size_t points = drive[0].size();
  ASSERT_EQ(result.labels.size(), points + 500);
  for (std::size_t i = 0; i < points; ++i) ASSERT_EQ(result.labels[i], expected.labels[i]) << i;
  for (std::size_t i = points; i < result.labels.size(); ++i) {
    EXPECT_EQ(result.labels[i], Label::unknown);
    EXPECT_TRUE(std::isnan(result.height_above_ground[i]));
  }
}

TEST(Input, AnswersMayBeWrittenIntoTheCallersMemory) {
  const std::vector<DriveScan> drive = street_drive(3);
  GroundGrid own;
  GroundGrid given;
  for (const DriveScan& drive_scan : drive) {
    const SensorScan scan = drive_scan.scan();
    const std::span<const SensorScan> scans(&scan, 1);
    std::vector<Label> labels(drive_scan.size());
    std::vector<float> heights(drive_scan.size());
    const Eigen::Isometry3d& pose = drive_scan.T_map_base;
    const ScanResult a = own.process({.scans = scans, .T_map_base = pose});
    const ScanResult b =
        given.process({.scans = scans, .T_map_base = pose, .output = ScanOutput{labels, heights}});
    EXPECT_EQ(b.labels.data(), labels.data());
    EXPECT_EQ(b.height_above_ground.data(), heights.data());
    EXPECT_TRUE(std::equal(a.labels.begin(), a.labels.end(), labels.begin(), labels.end()));
    EXPECT_EQ(
        std::memcmp(a.height_above_ground.data(), heights.data(), heights.size() * sizeof(float)),
        0);
    EXPECT_EQ(a.ground, b.ground);
    EXPECT_EQ(a.unknown, b.unknown);
  }
}

/// A grid that has seen a scan; what is rejected must leave it as it was.
class RejectedInput : public ::testing::Test {
 protected:
  RejectedInput() : drive_(street_drive(2)) {
    grid_.process(drive_[0].scan(), drive_[0].T_map_base);
    expected_.process(drive_[0].scan(), drive_[0].T_map_base);
  }

  /// Answers the second scan like one that has never been disturbed.
  void TearDown() override {
    EXPECT_TRUE(same_bits(run_drive(grid_, {drive_[1]}), run_drive(expected_, {drive_[1]})));
  }

  void expect_rejected(const SensorScan& scan, const Eigen::Isometry3d& pose) {
    EXPECT_THROW(grid_.process(scan, pose), std::invalid_argument);
  }

  std::vector<DriveScan> drive_;
  GroundGrid grid_;
  GroundGrid expected_;
};

TEST_F(RejectedInput, PosesThatAreNotFinite) {
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Eigen::Isometry3d pose = drive_[1].T_map_base;
    pose.translation().y() = value;
    expect_rejected(drive_[1].scan(), pose);
    pose = drive_[1].T_map_base;
    pose.linear()(0, 1) = value;
    expect_rejected(drive_[1].scan(), pose);
  }
}

TEST_F(RejectedInput, PosesThatAreNotRigid) {
  Eigen::Isometry3d scaled = drive_[1].T_map_base;
  scaled.linear() *= 1.1;
  expect_rejected(drive_[1].scan(), scaled);
  Eigen::Isometry3d mirrored = drive_[1].T_map_base;
  mirrored.linear().col(1) *= -1.0;
  expect_rejected(drive_[1].scan(), mirrored);
  Eigen::Isometry3d zero = drive_[1].T_map_base;
  zero.linear().setZero();
  expect_rejected(drive_[1].scan(), zero);
}

TEST_F(RejectedInput, MountingsThatAreNotRigid) {
  SensorScan scan = drive_[1].scan();
  scan.T_base_sensor = RigidTransform();
  scan.T_base_sensor->rows[0] = 2.0;
  expect_rejected(scan, drive_[1].T_map_base);
  scan.T_base_sensor->rows[0] = std::nan("");
  expect_rejected(scan, drive_[1].T_map_base);
}

TEST_F(RejectedInput, PosesAndMountingsOutOfThisWorld) {
  expect_rejected(drive_[1].scan(), testing::pose(2e9, 0.0, 0.0));
  expect_rejected(drive_[1].scan(), testing::pose(0.0, 0.0, -1e300));
  SensorScan scan = drive_[1].scan();
  scan.T_base_sensor = testing::pose(0.0, 2e9, 1.75);
  expect_rejected(scan, drive_[1].T_map_base);
}

TEST_F(RejectedInput, TooManyPoints) {
  const std::vector<float> one(3);
  SensorScan scan;
  scan.points = PointView::from_floats(one.data(), 4'194'305, 0);
  expect_rejected(scan, drive_[1].T_map_base);  // no stride
  std::vector<float> many(3 * 4'194'305UL);
  scan.points = PointView::from_floats(many.data(), 4'194'305, 3);
  expect_rejected(scan, drive_[1].T_map_base);
}

TEST_F(RejectedInput, CountsWhoseSumWrapsRoundToZero) {
  std::vector<SensorScan> scans(2, drive_[1].scan());
  for (SensorScan& scan : scans)
    scan.points.count = std::numeric_limits<std::size_t>::max() / 2 + 1;
  EXPECT_THROW(grid_.process({.scans = scans, .T_map_base = drive_[1].T_map_base}),
               std::invalid_argument);
}

TEST_F(RejectedInput, ScansOnAWayLongerThanAJump) {
  const SensorScan scan = drive_[1].scan();
  Eigen::Isometry3d begin = drive_[1].T_map_base;
  begin.translation().x() += kPoseJump_m + 1.0;
  EXPECT_THROW(grid_.process({.scans = std::span(&scan, 1),
                              .T_map_base = drive_[1].T_map_base,
                              .T_map_base_begin = begin}),
               std::invalid_argument);
}

TEST_F(RejectedInput, ViewsThatReachOutOfTheirRecords) {
  const SensorScan good = drive_[1].scan();
  const auto rejects = [&](auto change) {
    SensorScan scan = good;
    change(scan.points);
    expect_rejected(scan, drive_[1].T_map_base);
  };
  rejects([](PointView& view) { view.data = nullptr; });
  rejects([](PointView& view) { view.stride_bytes = 0; });
  rejects([](PointView& view) { view.stride_bytes = 11; });
  rejects([](PointView& view) { view.x_offset = 9; });
  rejects([](PointView& view) { view.y_offset = 12; });
  rejects([](PointView& view) { view.z_offset = std::numeric_limits<std::size_t>::max(); });
  rejects([](PointView& view) { view.time_offset = 8; });
}

TEST_F(RejectedInput, OutputsOfAnotherLength) {
  const SensorScan scan = drive_[1].scan();
  const std::span<const SensorScan> scans(&scan, 1);
  const Eigen::Isometry3d& pose = drive_[1].T_map_base;
  std::vector<Label> labels(drive_[1].size() + 1);
  std::vector<float> heights(drive_[1].size());
  EXPECT_THROW(
      grid_.process({.scans = scans, .T_map_base = pose, .output = ScanOutput{labels, heights}}),
      std::invalid_argument);
  labels.resize(drive_[1].size());
  heights.pop_back();
  EXPECT_THROW(
      grid_.process({.scans = scans, .T_map_base = pose, .output = ScanOutput{labels, heights}}),
      std::invalid_argument);
}

TEST_F(RejectedInput, ScansThatEndBeforeTheyBegin) {
  const testing::SimulatedScan simulated =
      testing::cast_scan({}, {}, testing::pose(0, 0, 0), testing::pose(0, 0, 1.75), 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.time_begin = 1.0;
  const Eigen::Isometry3d begin = drive_[0].T_map_base;
  const Eigen::Isometry3d end = drive_[1].T_map_base;
  const std::span<const SensorScan> scans(&scan, 1);
  for (const double time_end : {1.0, 0.5, std::nan("")}) {
    scan.time_end = time_end;
    EXPECT_THROW(grid_.process({.scans = scans, .T_map_base = end, .T_map_base_begin = begin}),
                 std::invalid_argument)
        << time_end;
  }
}

TEST(Input, CellsOutsideOfTheTerrainAreRejected) {
  GroundGrid grid;
  EXPECT_THROW(static_cast<void>(grid.terrain().cell(0, 0)), std::out_of_range);
  grid.process(street_drive(1)[0].scan());
  const TerrainView terrain = grid.terrain();
  EXPECT_NO_THROW(static_cast<void>(terrain.cell(0, terrain.size - 1)));
  EXPECT_THROW(static_cast<void>(terrain.cell(terrain.size, 0)), std::out_of_range);
  EXPECT_THROW(static_cast<void>(terrain.cell(0, -1)), std::out_of_range);
}

TEST(Input, ConfigsOutOfRangeAreRejected) {
  Config config;
  config.map.resolution_m = -1.0;
  EXPECT_THROW(GroundGrid{config}, std::invalid_argument);
}

}  // namespace
}  // namespace groundgrid
