#include "simulation/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace groundgrid::simulation {
namespace {

Sensor sensor() {
  Sensor sensor;
  sensor.least_range_m = 1.0;
  sensor.most_range_m = 50.0;
  sensor.noise_m = 0.02;
  sensor.range_step_m = 0.002;
  return sensor;
}

TEST(RandomNumbers, AreThoseOfTheirPurpose) {
  EXPECT_EQ(hash({1, 2, 3}), hash({1, 2, 3}));
  EXPECT_NE(hash({1, 2, 3}), hash({1, 3, 2}));
  EXPECT_NE(hash({0}), hash({0, 0}));
}

TEST(RandomNumbers, HaveTheMomentsTheySay) {
  constexpr int kCount = 20000;
  Random random(7);
  double uniform = 0.0, normal = 0.0, squares = 0.0, exponential = 0.0;
  for (int i = 0; i < kCount; ++i) {
    uniform += random.uniform() / kCount;
    const double value = random.normal();
    normal += value / kCount;
    squares += value * value / kCount;
    exponential += random.exponential() / kCount;
  }
  EXPECT_NEAR(uniform, 0.5, 0.01);
  EXPECT_NEAR(normal, 0.0, 0.03);
  EXPECT_NEAR(squares, 1.0, 0.05);
  EXPECT_NEAR(exponential, 1.0, 0.03);
}

TEST(Ranges, HaveTheNoiseAndTheStepsOfTheSensor) {
  double mean = 0.0, squares = 0.0;
  constexpr int kCount = 5000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    Random random(hash({i}));
    const double range = measured_range(sensor(), 20.0, 0.005, random);
    const double steps = range / 0.002;
    EXPECT_NEAR(steps, std::round(steps), 1e-6);
    mean += range / kCount;
    squares += (range - 20.005) * (range - 20.005) / kCount;
  }
  EXPECT_NEAR(mean, 20.005, 0.001);
  EXPECT_NEAR(std::sqrt(squares), 0.02, 0.001);
}

TEST(Ranges, TooShortOrTooLongAreNone) {
  Random random(1);
  EXPECT_EQ(measured_range(sensor(), 0.5, 0.0, random), 0.0);
  EXPECT_EQ(measured_range(sensor(), 51.0, 0.0, random), 0.0);
}

TEST(Edges, MixSomeRangesOfSurfacesThatAreClose) {
  const Echo pole{10.0, 80, 0.5F, false};
  const Echo wall{11.0, 50, 0.5F, false};
  int mixed = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(hash({i}));
    const Echo echo = mixed_at_edge(pole, wall, random);
    EXPECT_GE(echo.distance_m, 10.0);
    EXPECT_LE(echo.distance_m, 11.0);
    if (echo.distance_m != 10.0) ++mixed;
  }
  EXPECT_GT(mixed, 80);
  EXPECT_LT(mixed, 160);
}

TEST(Edges, LeaveSurfacesAloneThatAreFarApartOrTheSame) {
  const Echo pole{10.0, 80, 0.5F, false};
  for (const double distance : {0.0, 10.1, 13.0})
    for (std::uint64_t i = 0; i < 100; ++i) {
      Random random(hash({i}));
      EXPECT_EQ(mixed_at_edge(pole, {distance, 50, 0.5F, false}, random).distance_m, 10.0);
    }
}

// A point in the air beside a car is none of the ground behind it.
TEST(Edges, BetweenGroundAndAnObjectBelongToTheObject) {
  const Echo road{11.0, 40, 0.5F, true};
  const Echo car{10.0, 10, 0.5F, false};
  int mixed = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(hash({i}));
    const Echo echo = mixed_at_edge(road, car, random);
    if (echo.distance_m == 11.0) continue;
    ++mixed;
    EXPECT_EQ(echo.label, 10U);
  }
  EXPECT_GT(mixed, 5);
}

}  // namespace
}  // namespace groundgrid::simulation
