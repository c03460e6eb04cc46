// What rays bring back from small worlds on flat ground, 2 m under the sensor.
#include "simulation/echo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kMost_m = 80.0;

class Flat {
 public:
  explicit Flat(double grass_m = 0.0) {
    scene_.path = std::make_shared<const Path>(std::vector<Bend>{}, 10.0, 80.0);
    scene_.ground = [grass_m](const Eigen::Vector2d&) {
      return Ground{0.0, grass_m > 0.0 ? label::kTerrain : label::kRoad, grass_m};
    };
  }

  Scene& scene() { return scene_; }

  /// The echoes of many rays of the same direction.
  std::vector<Echo> cast(const Eigen::Vector3d& direction, std::size_t rays = 2000) {
    TileRunner runner(1);
    const Terrain terrain(*scene_.path, 10.0, scene_.ground, runner);
    World world(scene_, terrain);
    world.move_to(time_s, {0.0, 0.0});
    std::vector<Echo> echoes;
    for (std::size_t i = 0; i < rays; ++i)
      echoes.push_back(
          world.echo({{0.0, 0.0, 2.0}, direction.normalized()}, 0.5, kMost_m, Random(hash({i}))));
    return echoes;
  }

  double time_s = 0.0;

 private:
  Scene scene_;
};

struct Mean {
  double distance_m = 0.0;
  std::size_t count = 0;
};

Mean mean_of(const std::vector<Echo>& echoes, std::uint16_t label) {
  Mean mean;
  for (const Echo& echo : echoes)
    if (echo.distance_m > 0.0 && (echo.label & 0xFFFFU) == label) {
      mean.distance_m += echo.distance_m;
      ++mean.count;
    }
  if (mean.count > 0) mean.distance_m /= static_cast<double>(mean.count);
  return mean;
}

TEST(Echo, OfTheRoadIsWhereTheRoadIs) {
  const Mean road = mean_of(Flat().cast({3.0, 0.0, -2.0}), label::kRoad);
  EXPECT_NEAR(road.distance_m, std::sqrt(13.0), 1e-5);
  EXPECT_GT(road.count, 1900U);
  EXPECT_LT(road.count, 2000U);
}

TEST(Echo, OfTheSkyIsNone) {
  for (const Echo& echo : Flat().cast({1.0, 0.0, 0.1}, 20)) EXPECT_EQ(echo.distance_m, 0.0);
}

TEST(Echo, GetsLostAtGrazingAngles) {
  const std::size_t near = mean_of(Flat().cast({5.0, 0.0, -2.0}), label::kRoad).count;
  const std::size_t far = mean_of(Flat().cast({75.0, 0.0, -2.0}), label::kRoad).count;
  EXPECT_LT(far, near);
}

TEST(Echo, OfGrassIsSomewhereAboveTheSoil) {
  const std::vector<Echo> echoes = Flat(0.1).cast({3.0, 0.0, -2.0});
  for (const Echo& echo : echoes) {
    if (!(echo.distance_m > 0.0)) continue;
    const double height = 2.0 - echo.distance_m * 2.0 / std::sqrt(13.0);
    EXPECT_GT(height, -1e-5);
    EXPECT_LT(height, 0.1);
  }
  // The mean of the product of two numbers between 0 and 1 is a quarter.
  const double mean = 2.0 - mean_of(echoes, label::kTerrain).distance_m * 2.0 / std::sqrt(13.0);
  EXPECT_NEAR(mean, 0.025, 0.003);
}

// 5 to 7 m ahead with two returns a metre: e^-4 of the rays pass.
TEST(Echo, OfABushLiesAtARandomDepthInIt) {
  Flat flat;
  Mesh& leaves = flat.scene().leaves;
  add_box(leaves, {5.0, -1.0, 0.5}, {7.0, 1.0, 3.0},
          leaves.add_surface({.label = label::kVegetation, .reflectivity = 0.9F, .density = 2.0F}));
  const std::vector<Echo> echoes = flat.cast({1.0, 0.0, 0.0}, 4000);
  const Mean mean = mean_of(echoes, label::kVegetation);
  const double expected = 0.5 - 2.0 / (std::exp(4.0) - 1.0);
  EXPECT_NEAR(mean.distance_m, 5.0 + expected, 0.03);
  EXPECT_NEAR(static_cast<double>(mean.count) / 4000.0, (1.0 - std::exp(-4.0)) * 0.99, 0.01);
}

TEST(Echo, BehindABushIsSeenThroughIt) {
  Flat flat;
  Mesh& leaves = flat.scene().leaves;
  add_box(leaves, {5.0, -1.0, 0.5}, {6.0, 1.0, 3.0},
          leaves.add_surface({.label = label::kVegetation, .reflectivity = 0.9F, .density = 1.0F}));
  flat.scene().solids = make_wall(1.0, 0.2, 3.0, 0.5, label::kFence);
  Mesh wall;
  wall.append(flat.scene().solids, Eigen::Translation3d(10.0, -0.5, 0.0) *
                                       Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitZ()));
  flat.scene().solids = wall;
  const Mean mean = mean_of(flat.cast({1.0, 0.0, 0.0}, 4000), label::kFence);
  EXPECT_NEAR(static_cast<double>(mean.count) / 4000.0, std::exp(-1.0) * 0.99, 0.03);
  EXPECT_NEAR(mean.distance_m, 9.9, 0.01);
}

// Down at 45 degrees onto an upright painted wall 1.5 m ahead: the ray goes back down and meets
// the ground after as much again as the rest of its height asks for.
TEST(Echo, OfACarIsAtTimesThatOfTheGroundBeforeIt) {
  Flat flat;
  Mesh& solids = flat.scene().solids;
  add_box(solids, {1.5, -1.0, 0.0}, {3.0, 1.0, 1.5},
          solids.add_surface({label::kCar, 5, Material::paint, 0.5F, 0.0F}));
  const std::vector<Echo> echoes = flat.cast({1.0, 0.0, -1.0}, 20000);
  const Mean ghosts = mean_of(echoes, label::kOutlier);
  EXPECT_GT(ghosts.count, 100U);
  EXPECT_LT(ghosts.count, 500U);
  // 1.5 m forward and down, then 0.5 m back and down: the echo seems to be as far below the
  // ground as 2 m along the ray take it.
  EXPECT_NEAR(ghosts.distance_m, 2.0 * std::sqrt(2.0), 1e-4);
  EXPECT_GT(mean_of(echoes, label::kCar).count, 17000U);
}

TEST(Echo, OfWhatMovesIsWhereItIsByThen) {
  Flat flat;
  Mesh person;
  add_box(person, {-0.2, -0.2, 0.0}, {0.2, 0.2, 3.0},
          person.add_surface({.label = label::kMovingPerson, .reflectivity = 0.5F}));
  flat.scene().movers.push_back({person, {20.0, 0.0}, -1.5});
  flat.time_s = 4.0;
  EXPECT_NEAR(mean_of(flat.cast({1.0, 0.0, 0.0}), label::kMovingPerson).distance_m, 13.8, 1e-4);
}

}  // namespace
}  // namespace groundgrid::simulation
