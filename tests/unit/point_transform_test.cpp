// Transforms in single precision and the correction of motion within a scan.
#include "core/point_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <vector>

namespace groundgrid {
namespace {

struct TimedPoint {
  float x, y, z, padding;
  double time;
};

PointView view_of(const std::vector<TimedPoint>& points) {
  PointView view;
  view.data = reinterpret_cast<const std::byte*>(points.data());
  view.count = points.size();
  view.stride_bytes = sizeof(TimedPoint);
  view.time_offset = offsetof(TimedPoint, time);
  return view;
}

void expect_near(const Point3f& a, const Eigen::Vector3d& b, double tolerance) {
  EXPECT_NEAR(static_cast<double>(a.x), b.x(), tolerance);
  EXPECT_NEAR(static_cast<double>(a.y), b.y(), tolerance);
  EXPECT_NEAR(static_cast<double>(a.z), b.z(), tolerance);
}

TEST(PointTransform, TurnsAndMoves) {
  // A quarter turn about z takes (1, 2, 3) to (−2, 1, 3); then (10, 20, 30) is added.
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  transform.translation() << 10.0, 20.0, 30.0;
  const PointTransform in_floats(transform);
  expect_near(in_floats.apply({1.0F, 2.0F, 3.0F}), {8.0, 21.0, 33.0}, 1e-5);
  expect_near(in_floats.origin(), {10.0, 20.0, 30.0}, 0.0);
}

TEST(SensorTrajectory, MovesEachPointByThePoseAtItsTime) {
  Eigen::Isometry3d begin = Eigen::Isometry3d::Identity();
  begin.translation() << 60.0, 60.0, 0.0;
  Eigen::Isometry3d end = begin;
  end.translation() += Eigen::Vector3d(2.0, 0.0, 0.1);
  end.linear() = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  T_base_sensor.translation() << 1.0, 0.0, 1.7;

  std::vector<TimedPoint> points;
  for (int i = 0; i <= 1000; ++i)
    points.push_back({30.0F, -20.0F, -1.7F, 0.0F, 100.0 + 0.1 * i / 1000.0});
  const PointView view = view_of(points);
  SensorTrajectory trajectory;
  trajectory.set_moving(begin, end, T_base_sensor, 100.0, 100.1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double share = static_cast<double>(i) / 1000.0;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(0.2 * share, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() = begin.translation() + share * (end.translation() - begin.translation());
    expect_near(trajectory.at(view, i).apply({30.0F, -20.0F, -1.7F}),
                pose * T_base_sensor * Eigen::Vector3d(30.0, -20.0, -1.7), 1e-4);
  }
  expect_near(trajectory.end().origin(), (end * T_base_sensor).translation(), 1e-5);
}

TEST(SensorTrajectory, TimesOutsideOfTheScanTakeTheNearerEnd) {
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();
  end.translation() << 4.0, 0.0, 0.0;
  const std::vector<TimedPoint> points{
      {0, 0, 0, 0, -1e9}, {0, 0, 0, 0, 1e9}, {0, 0, 0, 0, std::nan("")}};
  const PointView view = view_of(points);
  SensorTrajectory trajectory;
  trajectory.set_moving(Eigen::Isometry3d::Identity(), end, Eigen::Isometry3d::Identity(), 0.0,
                        1.0);
  EXPECT_FLOAT_EQ(trajectory.at(view, 0).origin().x, 0.0F);
  EXPECT_FLOAT_EQ(trajectory.at(view, 1).origin().x, 4.0F);
  EXPECT_TRUE(std::isfinite(trajectory.at(view, 2).origin().x));
}

TEST(LoadTime, ReadsTheTypesThatDriversWrite) {
  std::byte record[40];
  PointView view;
  view.data = record;
  view.count = 2;
  view.stride_bytes = 20;
  view.time_offset = 11;  // of the second record: 31, aligned to nothing
  const auto load_as = [&](TimeType type, auto value) {
    std::memcpy(record + 31, &value, sizeof(value));
    view.time_type = type;
    EXPECT_EQ(size_of(type), sizeof(value));
    return load_time(view, 1);
  };
  EXPECT_EQ(load_as(TimeType::float64, 1700000000.0625), 1700000000.0625);
  EXPECT_EQ(load_as(TimeType::float32, 0.0625F), 0.0625);
  EXPECT_EQ(load_as(TimeType::uint32, std::uint32_t{4'000'000'000U}), 4e9);
}

TEST(SensorTrajectory, IsFixedAgainAfterAFixedScan) {
  SensorTrajectory trajectory;
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();
  end.translation() << 4.0, 0.0, 0.0;
  trajectory.set_moving(Eigen::Isometry3d::Identity(), end, Eigen::Isometry3d::Identity(), 0.0,
                        1.0);
  trajectory.set_fixed(Eigen::Isometry3d::Identity());
  const std::vector<TimedPoint> points{{0, 0, 0, 0, 1.0}};
  EXPECT_FALSE(trajectory.moving());
  EXPECT_EQ(trajectory.at(view_of(points), 0).origin().x, 0.0F);
}

TEST(LoadTime, ReadsWhatDriversWrite) {
  struct Record {
    float x, y, z;
    float seconds;
    std::uint32_t nanoseconds;
  };
  const std::vector<Record> records{{0, 0, 0, 0.0F, 0}, {0, 0, 0, -0.05F, 99'000'000}};
  PointView view{reinterpret_cast<const std::byte*>(records.data()), records.size(),
                 sizeof(Record)};
  view.time_offset = offsetof(Record, seconds);
  view.time_type = TimeType::float32;
  EXPECT_EQ(load_time(view, 1), static_cast<double>(-0.05F));
  view.time_offset = offsetof(Record, nanoseconds);
  view.time_type = TimeType::uint32;
  EXPECT_EQ(load_time(view, 1), 99e6);
}

}  // namespace
}  // namespace groundgrid
