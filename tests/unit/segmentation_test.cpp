// Paper III-F: the thresholds h_g and h_o.
#include "core/segmentation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

TEST(Segment, ComparesWithTheThresholdOfTheCellsKind) {
  const Config config = metre_grid(11);  // h_g = 0.3 m, h_o = 0.1 m
  ElevationMap map = flat_map(config);
  const std::size_t ground_cell = cell_index(map, 2, 2);
  const std::size_t other_cell = cell_index(map, 7, 2);
  map.height()[ground_cell] = 0.5F;
  map.height()[other_cell] = -0.5F;
  std::vector<std::uint8_t> is_ground(map.cells());
  is_ground[ground_cell] = 1;

  PointsInCells points(map);
  points.add(2, 2, {0.799, 0.801, -3.0});
  points.add(7, 2, {-0.401, -0.399});
  std::vector<Label> labels(5, Label::unknown);
  std::vector<float> heights(5);
  TileRunner runner(1);
  CellLimits limits(map, runner);
  limits.choose_by_class(points.grid(), is_ground, map, config);
  const LabelCounts counts = segment(points.bins(), limits, map, config, runner, labels, heights);

  EXPECT_EQ(labels, (std::vector<Label>{Label::ground, Label::obstacle, Label::ground,
                                        Label::ground, Label::obstacle}));
  EXPECT_EQ(counts.ground, 3U);
  EXPECT_EQ(counts.obstacle, 2U);
  EXPECT_EQ(counts.outlier + counts.unknown, 0U);
  const std::vector<float> expected{0.299F, 0.301F, -3.5F, 0.099F, 0.101F};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(heights[i], expected[i], 1e-5F);
}

TEST(Segment, MeasuresOutliersFromTheMapAndPointsWithoutACellFromNothing) {
  const Config config = metre_grid(11);
  ElevationMap map = flat_map(config);
  map.height()[7] = 0.25F;
  BinnedPoints bins;
  bins.cell = {7 | BinnedPoints::kOutlier, BinnedPoints::kNoCell};
  bins.z = {-15000, 0};
  std::vector<Label> labels(2, Label::ground);
  std::vector<float> heights(2);
  TileRunner runner(1);
  const LabelCounts counts =
      segment(bins, CellLimits(map, runner), map, config, runner, labels, heights);
  EXPECT_EQ(labels, (std::vector<Label>{Label::outlier, Label::unknown}));
  EXPECT_EQ(counts.outlier, 1U);
  EXPECT_EQ(counts.unknown, 1U);
  EXPECT_NEAR(heights[0], -1.75F, 1e-5F);
  EXPECT_TRUE(std::isnan(heights[1]));
}

TEST(Segment, OnlyPointsDeepBelowTheTerrainAreOutliersOfThoseSetAside) {
  const Config config;  // deep: 0.3 m; h_g = 0.2 m
  const ElevationMap map = flat_map(config);
  BinnedPoints bins;
  bins.cell.assign(4, 7 | BinnedPoints::kOutlier);
  bins.z = {-3001, -2999, 1999, 2001};
  std::vector<Label> labels(4);
  std::vector<float> heights(4);
  TileRunner runner(1);
  const LabelCounts counts =
      segment(bins, CellLimits(map, runner), map, config, runner, labels, heights);
  EXPECT_EQ(labels, (std::vector<Label>{Label::outlier, Label::ground, Label::ground,
                                        Label::obstacle}));
  EXPECT_EQ(counts.outlier, 1U);
  EXPECT_EQ(counts.ground, 2U);
  EXPECT_EQ(counts.obstacle, 1U);
  EXPECT_EQ(counts.unknown, 0U);
}

}  // namespace
}  // namespace groundgrid
