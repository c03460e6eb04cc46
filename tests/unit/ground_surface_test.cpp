#include "core/stages/ground_surface.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::PointsInCells;

constexpr double kCell_m = 0.33;

Config small_map() {
  Config config;
  config.map.extent_m = 60 * kCell_m;
  return config;
}

/// A scan over a map of 61 × 61 cells, with a point in every cell that has a height.
class GroundSurfaceTest : public ::testing::Test {
 protected:
  using Height = std::function<std::optional<double>(int column, int row)>;

  GroundSurfaceTest()
      : map_(flat_map(small_map())),
        cells_(map_.cells()),
        supported_(map_.cells(), 1),
        surface_(map_, runner_) {}

  void process(const Height& height, const LocalPlane& ground = {}) {
    PointsInCells points(map_);
    for (int row = 0; row < map_.size(); ++row)
      for (int column = 0; column < map_.size(); ++column)
        if (const std::optional<double> z = height(column, row)) points.add(column, row, {*z});
    process(points, ground);
  }

  void process(PointsInCells& points, const LocalPlane& ground = {}) {
    TileRunner runner(1);
    const ScanGrid& grid = points.grid();
    const Point3f sensor{10.0F, 10.0F, 1.7F};
    cells_.classify(grid, map_, supported_, {&sensor, 1}, runner);
    surface_.withdraw_raised(grid, ground, cells_, map_);
    surface_.accept_lone(grid, cells_);
    for (std::size_t i = 0; i < grid.occupied.size(); ++i)
      if (cells_.cells()[i].ground)
        map_.height()[grid.occupied[i]] = cells_.cells()[i].patch_elevation;
    surface_.fill(grid, ground, small_map(), cells_, map_);
  }

  bool is_ground(int column, int row) const {
    return cells_.is_ground()[cell_index(map_, column, row)] == 1;
  }
  double height(int column, int row) const {
    return static_cast<double>(map_.height()[cell_index(map_, column, row)]);
  }
  float& confidence(int column, int row) {
    return map_.confidence()[cell_index(map_, column, row)];
  }

  ElevationMap map_;
  GroundCells cells_;
  std::vector<std::uint8_t> supported_;
  TileRunner runner_{2};
  GroundSurface surface_;
};

bool inside(int column, int row, int first, int count) {
  return column >= first && column < first + count && row >= first && row < first + count;
}

TEST_F(GroundSurfaceTest, FlatGroundStays) {
  process([](int, int) { return 0.0; });
  for (int i = 0; i < map_.size(); ++i) EXPECT_TRUE(is_ground(i, i));
}

TEST_F(GroundSurfaceTest, AHillsideStays) {
  process([](int column, int) { return 0.4 * kCell_m * (column - 30); });
  for (int i = 0; i < map_.size(); ++i) EXPECT_TRUE(is_ground(i, i)) << i;
}

TEST_F(GroundSurfaceTest, ARoofIsNoGroundAndItsCellsTakeTheHeightAround) {
  process([](int column, int row) { return inside(column, row, 28, 4) ? 1.4 : 0.0; });
  EXPECT_FALSE(is_ground(29, 29));
  EXPECT_NEAR(height(29, 29), 0.0, 0.1);
  EXPECT_TRUE(is_ground(20, 29));
  EXPECT_TRUE(is_ground(33, 33));
}

TEST_F(GroundSurfaceTest, AWideTerraceIsGroundAndANarrowOneIsNot) {
  const auto terrace = [](int cells) {
    return [cells](int column, int row) { return inside(column, row, 26, cells) ? 0.7 : 0.0; };
  };
  process(terrace(9));
  EXPECT_TRUE(is_ground(30, 30));
  process(terrace(4));
  EXPECT_FALSE(is_ground(27, 27));
}

TEST_F(GroundSurfaceTest, AWideRoofIsTooHighForATerrace) {
  process([](int column, int row) { return inside(column, row, 26, 9) ? 3.0 : 0.0; });
  EXPECT_FALSE(is_ground(30, 30));
}

TEST_F(GroundSurfaceTest, ALoneCellIsGroundIfItLiesOnTheSurfaceOfTheOthers) {
  const std::size_t lone = cell_index(map_, 30, 30);
  supported_[lone] = 0;
  const auto is_ground_at = [&](double height) {
    map_ = flat_map(small_map());
    // Nothing else is in its patch.
    process([=](int column, int row) -> std::optional<double> {
      if (column == 30 && row == 30) return height;
      return inside(column, row, 28, 5) ? std::nullopt : std::optional(0.0);
    });
    return is_ground(30, 30);
  };
  EXPECT_TRUE(is_ground_at(0.15));
  EXPECT_TRUE(is_ground_at(-0.4));
  EXPECT_FALSE(is_ground_at(0.25));
  EXPECT_FALSE(is_ground_at(-0.6));
  EXPECT_NEAR(height(29, 30), 0.0, 1e-4) << "it has no part in the surface";
}

TEST_F(GroundSurfaceTest, WhatIsRememberedAboveTheSurfaceIsForgotten) {
  confidence(30, 30) = 0.4F;
  map_.height()[cell_index(map_, 30, 30)] = 1.0F;
  process([](int column, int row) {
    return column == 30 && row == 30 ? std::nullopt : std::optional(0.0);
  });
  EXPECT_EQ(confidence(30, 30), 0.0F);
  EXPECT_NEAR(height(30, 30), 0.0, 0.05);
}

TEST_F(GroundSurfaceTest, WhatIsRememberedOnTheSurfaceStaysAndFadesByEquation8) {
  confidence(30, 30) = 0.4F;
  map_.height()[cell_index(map_, 30, 30)] = 0.05F;
  process([](int column, int row) {
    return column == 30 && row == 30 ? std::nullopt : std::optional(0.0);
  });
  EXPECT_FLOAT_EQ(confidence(30, 30), 0.4F - 0.4F / 5.0F);
  EXPECT_FLOAT_EQ(map_.height()[cell_index(map_, 30, 30)], 0.05F);
}

TEST_F(GroundSurfaceTest, WhatNobodySawLiesOnTheSlopeAround) {
  process([](int column, int row) {
    return inside(column, row, 25, 11) ? std::nullopt
                                       : std::optional(0.2 * kCell_m * (column - 30));
  });
  for (int column = 25; column < 36; ++column)
    EXPECT_NEAR(height(column, 30), 0.2 * kCell_m * (column - 30), 0.05);
}

TEST_F(GroundSurfaceTest, WithoutAnythingSeenThePlaneOfTheVehicleGoesOn) {
  process([](int, int) { return std::nullopt; }, {0.5, 0.1, 0.0});
  EXPECT_NEAR(height(40, 30), 0.5 + 0.1 * 10 * kCell_m, 1e-4);
  EXPECT_NEAR(height(30, 10), 0.5, 1e-4);
}

TEST_F(GroundSurfaceTest, TheGroundIsNowhereAboveALowestReturn) {
  PointsInCells points(map_);
  for (int row = 0; row < map_.size(); ++row)
    for (int column = 0; column < map_.size(); ++column)
      if (row != 30) points.add(column, row, {0.0});
  points.add(10, 30, {-0.3, 2.0});  // below the surface
  points.add(20, 30, {0.05, 2.0});  // hardly above it
  points.add(40, 30, {0.25, 2.0});  // above it: the foot of something
  process(points);
  EXPECT_FALSE(is_ground(10, 30));
  EXPECT_NEAR(height(10, 30), -0.3, 1e-4);
  EXPECT_NEAR(height(20, 30), 0.05, 1e-4);
  EXPECT_NEAR(height(40, 30), 0.0, 0.02);
}

}  // namespace
}  // namespace groundgrid
