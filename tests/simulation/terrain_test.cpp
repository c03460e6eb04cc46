#include "simulation/terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/ray_caster.hpp"

namespace groundgrid::simulation {
namespace {

Ground hills(const Eigen::Vector2d& place) {
  return {3.0 * std::sin(place.x() / 17.0) + 0.04 * place.y(), 72, 0.0};
}

TEST(Terrain, OfAPlaneIsThePlane) {
  TileRunner runner(2);
  const Path path({}, 20.0, 60.0);
  const Terrain terrain(
      path, 20.0,
      [](const Eigen::Vector2d& place) {
        return Ground{0.1 * place.x() - 0.02 * place.y() + 5.0, 40, 0.0};
      },
      runner);
  for (double x = -50.0; x < 70.0; x += 6.7)
    for (double y = -55.0; y < 55.0; y += 5.9)
      EXPECT_NEAR(terrain.height({x, y}), 0.1 * x - 0.02 * y + 5.0, 1e-4);
}

TEST(Terrain, IsFineBesideThePath) {
  TileRunner runner(1);
  const Terrain terrain(Path({}, 20.0, 60.0), 20.0, hills, runner);
  for (double x = -10.0; x < 30.0; x += 1.7)
    EXPECT_NEAR(terrain.height({x, 0.3 * x}), hills({x, 0.3 * x}).height_m, 1e-3);
}

// The truth is what rays meet, also where squares of different sizes do.
TEST(Terrain, HeightIsWhatAVerticalRayMeets) {
  TileRunner runner(1);
  const Terrain terrain(Path({{0.3, 90.0, 0.0}}, 20.0, 60.0), 20.0, hills, runner);
  const RayCaster caster({&terrain.mesh()});
  for (double x = -60.0; x < 80.0; x += 1.37)
    for (double y = -60.0; y < 60.0; y += 3.31) {
      const auto hit = caster.cast({{x, y, 50.0}, -Eigen::Vector3d::UnitZ()}, 0.0, 100.0);
      ASSERT_TRUE(hit) << x << ' ' << y;
      EXPECT_NEAR(50.0 - hit->distance_m, terrain.height({x, y}), 1e-4) << x << ' ' << y;
    }
}

TEST(Terrain, IsTheSameForAnyNumberOfThreads) {
  TileRunner one(1);
  TileRunner two(2);
  const Path path({{0.3, 90.0, 0.0}}, 10.0, 60.0);
  EXPECT_EQ(Terrain(path, 10.0, hills, one).mesh().vertices,
            Terrain(path, 10.0, hills, two).mesh().vertices);
}

}  // namespace
}  // namespace groundgrid::simulation
