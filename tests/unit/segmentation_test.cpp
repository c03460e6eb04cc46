// Paper III-F: the thresholds h_g and h_o.
#include "core/stages/segmentation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

TEST(Segment, MeasuresOutliersFromTheMapAndPointsWithoutACellFromNothing) {
  const Config config;
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
  EXPECT_EQ(labels,
            (std::vector<Label>{Label::outlier, Label::ground, Label::ground, Label::obstacle}));
  EXPECT_EQ(counts.outlier, 1U);
  EXPECT_EQ(counts.ground, 2U);
  EXPECT_EQ(counts.obstacle, 1U);
  EXPECT_EQ(counts.unknown, 0U);
}

}  // namespace
}  // namespace groundgrid
