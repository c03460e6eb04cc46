// Paper III-D: what a scan does to the cells of the map.
#include "core/stages/ground_elevation.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

TEST(UpdateElevation, TakesGroundAndObstacleCellsIntoTheMapAndLeavesOutUnsupportedOnes) {
  const Config config = metre_grid(11);
  ElevationMap map = flat_map(config);
  PointsInCells points(map);
  points.add(2, 2, {0.1, 0.1, 0.1, 0.1, 0.1});  // flat: ground
  points.add(5, 8, {-0.4, 0.6});                // varies, below the map: an obstacle's foot
  points.add(8, 2, {0.3, 0.9});                 // varies, above the map
  const std::size_t ground = cell_index(map, 2, 2);
  const std::size_t below = cell_index(map, 5, 8);
  const std::size_t above = cell_index(map, 8, 2);
  for (const std::size_t cell : {ground, below, above}) map.confidence()[cell] = 0.25F;

  TileRunner runner(1);
  const Point3f sensor{5.5F, 5.5F, 1.7F};
  GroundCells cells(map.cells());
  cells.classify(points.grid(), map, std::vector<std::uint8_t>(map.cells(), 1), {&sensor, 1},
                 runner);
  update_elevation(points.grid(), cells, config, runner, map);

  // q = 5/20; (0.25·0.1 + 0.25·0) / 0.5 = 0.05; (0.125 + 0.25) / 2 = 0.1875
  EXPECT_NEAR(map.height()[ground], 0.05F, 1e-6F);
  EXPECT_NEAR(map.confidence()[ground], 0.1875F, 1e-6F);
  EXPECT_NEAR(map.height()[below], -0.4F, 1e-6F);
  EXPECT_NEAR(map.confidence()[below], 0.35F, 1e-6F);
  EXPECT_FLOAT_EQ(map.height()[above], 0.0F);
  EXPECT_FLOAT_EQ(map.confidence()[above], 0.25F);

  // The same scan without support changes nothing.
  const std::vector<float> before = map.height();
  cells.classify(points.grid(), map, std::vector<std::uint8_t>(map.cells()), {&sensor, 1}, runner);
  update_elevation(points.grid(), cells, config, runner, map);
  EXPECT_EQ(map.height(), before);
}

}  // namespace
}  // namespace groundgrid
