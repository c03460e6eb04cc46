#include "groundgrid/terrain_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/map/cell_statistics.hpp"

namespace groundgrid {
namespace {

TEST(TerrainView, CellGivesHeightsInTheMapFrame) {
  const std::vector<float> height{0.0F, 0.5F, 0.0F, -0.25F};
  const std::vector<float> confidence{0.0F, 0.75F, 0.0F, 0.0F};
  std::vector<CellStatistics> statistics(4);
  // Two points 0.4 and 0.6 m above the origin: 4000 and 6000 steps; variance 0.1² = 0.01.
  statistics[1] = {10000, 16'000'000 + 36'000'000, 4000, 6000, 2};
  TerrainView view;
  view.size = 2;
  view.z_origin_m = 100.0;
  view.relative_height = height;
  view.confidence = confidence;
  view.statistics = statistics.data();

  const TerrainCell seen = view.cell(1, 0);
  EXPECT_DOUBLE_EQ(seen.height, 100.5);
  EXPECT_EQ(seen.confidence, 0.75F);
  EXPECT_EQ(seen.points, 2U);
  EXPECT_NEAR(seen.variance, 0.01F, 1e-9F);
  EXPECT_DOUBLE_EQ(seen.lowest, 100.4);
  EXPECT_DOUBLE_EQ(seen.highest, 100.6);

  const TerrainCell unseen = view.cell(1, 1);
  EXPECT_DOUBLE_EQ(unseen.height, 99.75);
  EXPECT_EQ(unseen.points, 0U);
  EXPECT_TRUE(std::isnan(unseen.variance));
  EXPECT_TRUE(std::isnan(unseen.lowest));
  EXPECT_TRUE(std::isnan(unseen.highest));
}

}  // namespace
}  // namespace groundgrid
