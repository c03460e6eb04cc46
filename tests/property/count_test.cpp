// As many answers as points, whatever the points are.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"

namespace groundgrid {
namespace {

using testing::DriveScan;
using testing::street_drive;

SensorScan scan_of(const std::vector<float>& xyz) {
  SensorScan scan;
  scan.points = PointView::from_floats(xyz.data(), xyz.size() / 3, 3);
  return scan;
}

void expect_consistent(const ScanResult& result, std::size_t points) {
  ASSERT_EQ(result.labels.size(), points);
  ASSERT_EQ(result.height_above_ground.size(), points);
  EXPECT_EQ(result.ground + result.obstacle + result.outlier + result.unknown, points);
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const bool is_unknown = result.labels[i] == Label::unknown;
    unknown += is_unknown ? 1 : 0;
    ASSERT_EQ(std::isnan(result.height_above_ground[i]), is_unknown) << "point " << i;
  }
  EXPECT_EQ(unknown, result.unknown);
}

TEST(Count, NoPoints) {
  GroundGrid grid;
  expect_consistent(grid.process(SensorScan{}), 0);
  expect_consistent(grid.process(ScanRequest{}), 0);
  EXPECT_GT(grid.terrain().size, 0);
}

TEST(Count, OnePoint) {
  GroundGrid grid;
  expect_consistent(grid.process(scan_of({5.0F, 1.0F, -1.7F})), 1);
}

TEST(Count, ManyEqualPoints) {
  std::vector<float> xyz;
  for (int i = 0; i < 1000; ++i) xyz.insert(xyz.end(), {5.0F, 1.0F, -1.7F});
  GroundGrid grid;
  const ScanResult result = grid.process(scan_of(xyz));
  expect_consistent(result, 1000);
  for (const Label label : result.labels) EXPECT_EQ(label, result.labels[0]);
}

// Points that cannot be answered stand between those of a street scan.
TEST(Count, UnanswerablePointsAreUnknownAndDisturbNothing) {
  const float nan = std::nanf("");
  const float inf = std::numeric_limits<float>::infinity();
  const float huge = std::numeric_limits<float>::max();
  const float bad[][3] = {{nan, 0, 0},     {0, nan, 0},        {5, 5, nan},       {inf, 0, 0},
                          {0, -inf, 0},    {5, 5, inf},        {5, 5, -inf},      {huge, 0, 0},
                          {0, -huge, 0},   {5, 5, huge},       {5, 5, -huge},     {1e4F, 0, 0},
                          {nan, nan, nan}, {huge, huge, huge}, {-huge, inf, nan}, {5, 5, 1e30F}};
  const std::vector<float> good = street_drive(1)[0].points;
  std::vector<float> mixed;
  for (std::size_t i = 0; i < good.size() / 3; ++i) {
    const auto& unanswerable = bad[i % std::size(bad)];
    mixed.insert(mixed.end(), std::begin(unanswerable), std::end(unanswerable));
    mixed.insert(mixed.end(), good.begin() + static_cast<std::ptrdiff_t>(3 * i),
                 good.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
  }
  Config config;
  config.vehicle.sensor_height_m = 1.75;  // an estimate of it may lose the vote of a cell
  GroundGrid with(config);
  GroundGrid without(config);
  const ScanResult result = with.process(scan_of(mixed));
  const ScanResult expected = without.process(scan_of(good));
  expect_consistent(result, mixed.size() / 3);
  for (std::size_t i = 0; i < expected.labels.size(); ++i) {
    ASSERT_EQ(result.labels[2 * i], Label::unknown) << "bad point " << i % std::size(bad);
    ASSERT_EQ(result.labels[2 * i + 1], expected.labels[i]) << "good point " << i;
  }
}

TEST(Count, OnlyUnanswerablePoints) {
  GroundGrid grid;
  const std::vector<float> xyz(3000, std::nanf(""));
  const ScanResult result = grid.process(scan_of(xyz));
  expect_consistent(result, 1000);
  EXPECT_EQ(result.unknown, 1000U);
  // Such a scan fixes nothing: the next one is answered as by a fresh object.
  const DriveScan street = street_drive(1)[0];
  GroundGrid fresh;
  const ScanResult after = grid.process(street.scan());
  const ScanResult expected = fresh.process(street.scan());
  EXPECT_TRUE(std::equal(after.labels.begin(), after.labels.end(), expected.labels.begin()));
}

TEST(Count, TwoMillionPoints) {
  const std::vector<float> street = street_drive(1)[0].points;
  std::vector<float> xyz;
  xyz.reserve(6'000'000);
  while (xyz.size() < 6'000'000)
    xyz.insert(xyz.end(), street.begin(),
               street.begin() +
                   static_cast<std::ptrdiff_t>(std::min(street.size(), 6'000'000 - xyz.size())));
  GroundGrid grid;
  const ScanResult result = grid.process(scan_of(xyz));
  expect_consistent(result, 2'000'000);
  EXPECT_GT(result.ground, 500'000U);
  EXPECT_GT(result.obstacle, 100'000U);
}

TEST(Count, SeveralSensorsKeepTheirOrder) {
  const std::vector<DriveScan> drive = street_drive(1);
  const std::vector<float> none;
  std::vector<float> far(30, 1e5F);
  SensorScan scans[3] = {scan_of(far), scan_of(none), drive[0].scan()};
  for (SensorScan& scan : scans) scan.T_base_sensor = testing::pose(0.0, 0.0, 1.75);
  GroundGrid grid;
  const ScanResult result = grid.process({.scans = scans});
  expect_consistent(result, 10 + drive[0].size());
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(result.labels[i], Label::unknown);
  EXPECT_GT(result.ground, 1000U);
}

}  // namespace
}  // namespace groundgrid
