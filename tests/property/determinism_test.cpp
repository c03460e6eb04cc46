// The same bits for any number of threads, any repetition and any order of the points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <thread>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"
#include "support/real_data.hpp"

namespace groundgrid {
namespace {

using testing::DriveResult;
using testing::DriveScan;
using testing::run_drive;
using testing::same_bits;
using testing::street_drive;

std::vector<DriveScan> real_drive(const std::filesystem::path& dataset, std::size_t scans) {
  std::vector<DriveScan> drive;
  for (testing::RealScan& real : testing::read_scans(dataset, "00", scans))
    drive.push_back({std::move(real.points), 4, real.T_map_lidar, std::nullopt});
  return drive;
}

Config with_steps() {
  Config config;
  config.labels.max_step_m = 0.05;
  return config;
}

void expect_same_bits_for_all_threads(const Config& config, const std::vector<DriveScan>& drive) {
  const DriveResult expected = run_drive(config, drive);
  for (const int threads : {1, 2, 3, 8})
    EXPECT_TRUE(same_bits(run_drive(config, drive, threads), expected)) << threads << " threads";
}

/// Shuffles the points of every scan; element i of an order says where point i came from.
std::vector<std::vector<std::size_t>> shuffle(std::vector<DriveScan>& drive, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<std::size_t>> orders;
  for (DriveScan& scan : drive) {
    std::vector<std::size_t>& order = orders.emplace_back(scan.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    const std::vector<float> points = scan.points;
    const std::size_t floats = scan.floats_per_point;
    for (std::size_t i = 0; i < order.size(); ++i)
      std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(order[i] * floats), floats,
                  scan.points.begin() + static_cast<std::ptrdiff_t>(i * floats));
  }
  return orders;
}

void unshuffle(DriveResult& result, const std::vector<std::vector<std::size_t>>& orders) {
  const DriveResult shuffled = result;
  std::size_t first = 0;
  for (const std::vector<std::size_t>& order : orders) {
    for (std::size_t i = 0; i < order.size(); ++i) {
      result.labels[first + order[i]] = shuffled.labels[first + i];
      result.height_above_ground[first + order[i]] = shuffled.height_above_ground[first + i];
    }
    first += order.size();
  }
}

void expect_same_bits_for_any_order(const Config& config, const std::vector<DriveScan>& drive) {
  const DriveResult expected = run_drive(config, drive);
  for (const int threads : {1, 3}) {
    std::vector<DriveScan> shuffled = drive;
    const auto orders = shuffle(shuffled, static_cast<unsigned>(threads));
    DriveResult result = run_drive(config, shuffled, threads);
    unshuffle(result, orders);
    EXPECT_TRUE(same_bits(result, expected)) << threads << " threads";
  }
}

TEST(Determinism, AnyNumberOfThreads) {
  const std::vector<DriveScan> drive = street_drive(4);
  expect_same_bits_for_all_threads(Config{}, drive);
  expect_same_bits_for_all_threads(Config::paper(), drive);
  expect_same_bits_for_all_threads(with_steps(), drive);
}

TEST(Determinism, AnyNumberOfThreadsOnRealScans) {
  GROUNDGRID_NEEDS_DATA(dataset)
  const std::vector<DriveScan> drive = real_drive(*dataset, 3);
  expect_same_bits_for_all_threads(Config{}, drive);
  expect_same_bits_for_all_threads(Config::paper(), drive);
  expect_same_bits_for_all_threads(with_steps(), drive);
}

TEST(Determinism, AnyOrderOfThePoints) {
  const std::vector<DriveScan> drive = street_drive(4);
  expect_same_bits_for_any_order(Config{}, drive);
  expect_same_bits_for_any_order(Config::paper(), drive);
}

TEST(Determinism, AnyOrderOfThePointsOnRealScans) {
  GROUNDGRID_NEEDS_DATA(dataset)
  expect_same_bits_for_any_order(Config{}, real_drive(*dataset, 3));
  expect_same_bits_for_any_order(with_steps(), real_drive(*dataset, 3));
}

TEST(Determinism, RepeatedRuns) {
  const std::vector<DriveScan> drive = street_drive(4);
  const DriveResult first = run_drive({}, drive, 3);
  for (int run = 0; run < 5; ++run) EXPECT_TRUE(same_bits(run_drive({}, drive, 3), first));
}

TEST(Determinism, TheDriveHasSomethingOfEverything) {
  // Were all labels the same, the tests above would compare nothing.
  const DriveResult result = run_drive(Config{}, street_drive(4));
  const auto ground = std::count(result.labels.begin(), result.labels.end(), Label::ground);
  const auto obstacle = std::count(result.labels.begin(), result.labels.end(), Label::obstacle);
  EXPECT_GT(ground, 5000);
  EXPECT_GT(obstacle, 5000);
}

TEST(Determinism, TwoObjectsInTwoThreadsDoNotMeet) {
  const std::vector<DriveScan> drive = street_drive(4);
  const DriveResult expected = run_drive(Config{}, drive);
  for (const int threads : {1, 2}) {
    DriveResult results[2];
    const auto work = [&](int i) { results[i] = run_drive({}, drive, threads); };
    std::thread other(work, 0);
    work(1);
    other.join();
    EXPECT_TRUE(same_bits(results[0], expected));
    EXPECT_TRUE(same_bits(results[1], expected));
  }
}

}  // namespace
}  // namespace groundgrid
