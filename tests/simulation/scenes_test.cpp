// What is where in each scene, without a sensor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "simulation/drive.hpp"
#include "simulation/objects.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"
#include "simulation/scene_builder.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kLength_m = 250.0;

Ground ground_at(const Scene& scene, Station at) { return scene.ground(scene.path->point(at)); }

double height_at(const Scene& scene, Station at) { return ground_at(scene, at).height_m; }

/// What a ray from `up_m` above the ground meets, to the side (left is positive) or upward.
std::optional<std::uint16_t> label_met(const Scene& scene, const RayCaster& solids, Station at,
                                       double up_m, const Eigen::Vector3d& in_path,
                                       double reach_m) {
  const Eigen::Vector2d place = scene.path->point(at);
  const Eigen::AngleAxisd heading(scene.path->heading(at.s), Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d origin(place.x(), place.y(), height_at(scene, at) + up_m);
  const auto hit = solids.cast({origin, heading * in_path}, 0.0, reach_m);
  if (!hit) return std::nullopt;
  return scene.solids.surface(hit->triangle).label;
}

class EverySceneOnce : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, EverySceneOnce, ::testing::ValuesIn(scene_names()),
                         [](const auto& name) { return name.param; });

TEST_P(EverySceneOnce, NothingStandsInTheWay) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Scene scene = make_scene(GetParam(), seed, kLength_m);
    const RayCaster things({&scene.solids, &scene.leaves});
    for (double s = 0.0; s < kLength_m; s += 1.0)
      for (const double left : {-0.9, 0.0, 0.9})
        for (const double up : {0.5, 1.0, 1.6}) {
          const Station at{s, scene.lane_m + left};
          const Eigen::Vector2d from = scene.path->point(at);
          const Eigen::Vector2d to = scene.path->point({s + 1.0, at.d});
          const Eigen::Vector3d way(to.x() - from.x(), to.y() - from.y(),
                                    height_at(scene, {s + 1.0, at.d}) - height_at(scene, at));
          const Eigen::Vector3d origin(from.x(), from.y(), height_at(scene, at) + up);
          ASSERT_FALSE(things.cast({origin, way.normalized()}, 0.0, way.norm()))
              << "seed " << seed << ", s " << s << ", left " << left << ", up " << up;
        }
  }
}

TEST_P(EverySceneOnce, TheVehicleKeepsToTheGroundWithoutJumps) {
  constexpr double kDriven_m = 60.0;
  const Scene scene = make_scene(GetParam(), 2, kDriven_m);
  TileRunner runner(2);
  const Terrain terrain(*scene.path, kDriven_m, scene.ground, runner);
  const Drive drive(scene, terrain, 2);
  Eigen::Isometry3d before = drive.pose(0.0);
  Eigen::Vector3d step_before(0.1 * scene.speed_mps, 0.0, 0.0);
  for (double time = 0.1; time * scene.speed_mps < kDriven_m; time += 0.1) {
    const Eigen::Isometry3d pose = drive.pose(time);
    const Eigen::Vector3d step = pose.translation() - before.translation();
    EXPECT_NEAR(pose.translation().z(), terrain.height(pose.translation().head<2>()), 0.15);
    EXPECT_LT((step - step_before).norm(), 0.12);
    EXPECT_LT(Eigen::AngleAxisd((before.inverse() * pose).linear()).angle(), 0.06);
    before = pose;
    step_before = step;
  }
}

TEST_P(EverySceneOnce, ASeedGivesOneWorldAndAnotherSeedAnother) {
  const Scene scene = make_scene(GetParam(), 1, 100.0);
  const Scene again = make_scene(GetParam(), 1, 100.0);
  const Scene other = make_scene(GetParam(), 2, 100.0);
  EXPECT_EQ(scene.solids.vertices, again.solids.vertices);
  EXPECT_EQ(scene.leaves.vertices, again.leaves.vertices);
  EXPECT_NE(scene.solids.vertices, other.solids.vertices);
  EXPECT_EQ(height_at(scene, {70.0, 9.0}), height_at(again, {70.0, 9.0}));
  EXPECT_NE(height_at(scene, {70.0, 9.0}), height_at(other, {70.0, 9.0}));
}

// A longer drive begins in the same world.
TEST_P(EverySceneOnce, TheGroundDoesNotDependOnTheLength) {
  const Scene scene = make_scene(GetParam(), 1, 100.0);
  const Scene longer = make_scene(GetParam(), 1, 200.0);
  for (const double s : {0.0, 33.0, 90.0})
    for (const double d : {-20.0, -5.0, 0.0, 4.0, 15.0})
      EXPECT_NEAR(height_at(scene, {s, d}), height_at(longer, {s, d}), 1e-3);
}

TEST(Scenes, OneThatIsNotThereIsRefused) {
  EXPECT_THROW(make_scene("moon", 1, 10.0), std::invalid_argument);
  EXPECT_THROW((void)scene_speed_mps("moon"), std::invalid_argument);
}

TEST(Hill, TheRoadClimbsAbout23Metres) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const Scene scene = make_scene("hill", seed, kLength_m);
    double least = 0.0;
    double most = 0.0;
    for (double s = 0.0; s <= kLength_m; s += 1.0) {
      least = std::min(least, height_at(scene, {s, 0.0}));
      most = std::max(most, height_at(scene, {s, 0.0}));
    }
    EXPECT_NEAR(most - least, 23.0, 4.0) << seed;
  }
}

TEST(Hill, TheRoadLiesInCuttingsWithDitchesAndOnEmbankments) {
  const Scene scene = make_scene("hill", 1, kLength_m);
  std::size_t ditches = 0;
  std::size_t embankments = 0;
  for (double s = 0.0; s < kLength_m; s += 1.0)
    for (const double side : {-1.0, 1.0}) {
      const double edge = height_at(scene, {s, side * 3.6});
      const double ditch = height_at(scene, {s, side * 4.4}) - edge;
      const double behind = height_at(scene, {s, side * 7.0}) - edge;
      if (ditch < -0.12 && behind > 0.0) ++ditches;
      if (behind < -0.8) ++embankments;
    }
  EXPECT_GT(ditches, 50U);
  EXPECT_GT(embankments, 50U);
}

TEST(Motorway, SlopesAreOf30To40Percent) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Scene scene = make_scene("motorway", seed, kLength_m);
    std::set<int> percents;
    for (double s = 0.0; s < kLength_m; s += 2.0)
      for (const double side : {-1.0, 1.0}) {
        const double fall =
            height_at(scene, {s, side * 14.05}) - height_at(scene, {s, side * 14.75});
        percents.insert(static_cast<int>(std::lround(100.0 * fall / 0.7)));
      }
    // The verge is rough by some centimetres.
    EXPECT_GT(*percents.begin(), 30 - 9) << seed;
    EXPECT_LT(*percents.rbegin(), 40 + 9) << seed;
  }
}

TEST(Motorway, HasRailsAndABridgeThatLeavesRoom) {
  const Scene scene = make_scene("motorway", 1, kLength_m);
  const RayCaster solids({&scene.solids});
  const Station under{90.0, scene.lane_m};
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_FALSE(label_met(scene, solids, under, 0.2, up, 4.5));
  EXPECT_EQ(label_met(scene, solids, under, 0.2, up, 6.0), label::kOtherStructure);
  const Station free{60.0, scene.lane_m};
  EXPECT_FALSE(label_met(scene, solids, free, 0.2, up, 20.0));
  const Eigen::Vector3d left = Eigen::Vector3d::UnitY();
  EXPECT_EQ(label_met(scene, solids, free, 0.6, left, 12.0), label::kFence);
  EXPECT_EQ(label_met(scene, solids, free, 0.6, -left, 12.0), label::kFence);
}

TEST(Motorway, TheRoadOnTheBridgeRunsOnOverADam) {
  const Scene scene = make_scene("motorway", 1, kLength_m);
  const double road = height_at(scene, {90.0, 0.0});
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(height_at(scene, {90.0, side * 40.0}) - road, 6.0, 0.1);
    EXPECT_LT(height_at(scene, {90.0, side * 16.0}) - road, 0.5);
  }
}

TEST(Motorway, LorriesAreOnTheWay) {
  const Scene scene = make_scene("motorway", 1, kLength_m);
  EXPECT_GT(std::count_if(scene.movers.begin(), scene.movers.end(),
                          [](const Mover& mover) {
                            return mover.mesh.surfaces.front().label == label::kMovingTruck;
                          }),
            3);
}

TEST(Village, TheStreetClimbsUpTo15Percent) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Scene scene = make_scene("village", seed, kLength_m);
    double steepest = 0.0;
    for (double s = 0.0; s < kLength_m; s += 2.0)
      steepest =
          std::max(steepest, (height_at(scene, {s + 2.0, 0.0}) - height_at(scene, {s, 0.0})) / 2.0);
    EXPECT_GT(steepest, 0.12) << seed;
    EXPECT_LT(steepest, 0.18) << seed;
  }
}

TEST(Village, FlightsOfStepsLeadUpAndDown) {
  const Scene scene = make_scene("village", 1, kLength_m);
  std::size_t up = 0;
  std::size_t down = 0;
  for (double s = 0.5; s < kLength_m; s += 15.0)
    for (const double side : {-1.0, 1.0}) {
      // On the second and the third tread.
      const Station second{s, side * (4.4 + 1.5 * 0.32)};
      const Station third{s, side * (4.4 + 2.5 * 0.32)};
      if (ground_at(scene, second).label != label::kSidewalk) continue;
      const double rise = height_at(scene, third) - height_at(scene, second);
      if (std::abs(rise - 0.17) < 1e-6) ++up;
      if (std::abs(rise + 0.17) < 1e-6) ++down;
    }
  EXPECT_GT(up, 2U);
  EXPECT_GT(down, 2U);
}

TEST(Village, OtherLanesLieAboveAndBelow) {
  const Scene scene = make_scene("village", 1, kLength_m);
  for (const double s : {10.0, 100.0, 200.0}) {
    const double street = height_at(scene, {s, 0.0});
    EXPECT_NEAR(height_at(scene, {s, 24.0}) - street, 2.3, 0.01);
    EXPECT_NEAR(height_at(scene, {s, -24.0}) - street, -2.3, 0.01);
    EXPECT_EQ(ground_at(scene, {s, 24.0}).label, label::kRoad);
  }
}

// Else steep soil would pass for a wall.
TEST(Village, WallsStandWhereGardensEnd) {
  const Scene scene = make_scene("village", 1, kLength_m);
  const RayCaster solids({&scene.solids});
  std::size_t steps = 0;
  for (double s = 0.5; s < kLength_m; s += 1.0)
    for (const double side : {-1.0, 1.0}) {
      const Station pavement{s, side * 4.0};
      const Station garden{s, side * 4.8};
      const bool is_garden = ground_at(scene, garden).label == label::kTerrain;
      if (!is_garden || height_at(scene, garden) < height_at(scene, pavement) + 0.5) continue;
      ++steps;
      EXPECT_EQ(label_met(scene, solids, pavement, 0.4, side * Eigen::Vector3d::UnitY(), 0.8),
                label::kOtherStructure)
          << s << ' ' << side;
    }
  EXPECT_GT(steps, 100U);
}

TEST(Offroad, SomeFieldsArePloughedAndGrassVaries) {
  const Scene scene = make_scene("offroad", 1, kLength_m);
  std::size_t furrows = 0;
  double least = 1.0;
  double most = 0.0;
  for (double x = 0.0; x < kLength_m; x += 3.0)
    for (double y = -40.0; y < 40.0; y += 3.0) {
      const Eigen::Vector2d place(x, y);
      // Across a furrow and back, half of its width of 0.9 m each time.
      const Eigen::Vector2d across = 0.45 * Eigen::Vector2d(0.3, 0.95).normalized();
      double curve = 0.0;
      for (int i = -4; i <= 4; ++i)
        curve += (i % 2 == 0 ? 1.0 : -1.0) * scene.ground(place + i * across).height_m;
      if (std::abs(curve) > 0.35) ++furrows;
      if (scene.ground(place).label != label::kTerrain) continue;
      least = std::min(least, scene.ground(place).grass_m);
      most = std::max(most, scene.ground(place).grass_m);
    }
  EXPECT_GT(furrows, 100U);
  EXPECT_LT(least, 0.05);
  EXPECT_GT(most, 0.25);
  EXPECT_LT(most, 0.35);
}

TEST(Offroad, RocksLieAbout) {
  const Scene scene = make_scene("offroad", 1, kLength_m);
  EXPECT_GT(std::count_if(scene.solids.surfaces.begin(), scene.solids.surfaces.end(),
                          [](const Surface& each) { return each.label == label::kOtherObject; }),
            20);
}

TEST(SceneBuilder, AParkedCarHasItsWheelsOnTheSlope) {
  SceneBuilder builder(1, {}, 50.0);
  builder.set_ground([](const Eigen::Vector2d& place) {
    return Ground{0.15 * place.x() - 0.1 * place.y(), 40, 0.0};
  });
  builder.park(make_car(Random(1), label::kCar, 1), {20.0, 3.0}, 0.0);
  const Scene scene = builder.finish();
  for (const double forward : {-1.0, 1.0})
    for (const double left : {-1.0, 1.0}) {
      double lowest = 10.0;
      for (const Eigen::Vector3f& vertex : scene.solids.vertices) {
        const Eigen::Vector3d at = vertex.cast<double>();
        if ((at.x() - 20.0) * forward < 0.0 || (at.y() - 3.0) * left < 0.0) continue;
        lowest = std::min(lowest, at.z() - (0.15 * at.x() - 0.1 * at.y()));
      }
      EXPECT_NEAR(lowest, 0.0, 0.03);
    }
}

}  // namespace
}  // namespace groundgrid::simulation
