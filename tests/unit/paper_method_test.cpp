// The paper's page, step by step, against values worked out by hand.
#include "core/method/paper_method.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/method/spiral.hpp"
#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

struct KnownCell {
  int column;
  int row;
  float height;
  float confidence;
  bool ground;
};

struct TinyMap {
  Config config;
  ElevationMap map;
  std::vector<std::uint8_t> is_ground;

  TinyMap(int size, std::initializer_list<KnownCell> known)
      : config(metre_grid(size)), map(flat_map(config)), is_ground(map.cells()) {
    for (const KnownCell& cell : known) {
      const std::size_t index = cell_index(map, cell.column, cell.row);
      map.height()[index] = cell.height;
      map.confidence()[index] = cell.confidence;
      is_ground[index] = cell.ground ? 1 : 0;
    }
  }

  void interpolate(int column, int row) {
    const Point3f sensor{static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F, 1.7F};
    paper::interpolate_terrain({{}, {&sensor, 1}}, is_ground, config, map);
  }
  float height(int column, int row) { return map.height()[cell_index(map, column, row)]; }
  float confidence(int column, int row) { return map.confidence()[cell_index(map, column, row)]; }
};

TEST(InterpolateTerrain, GoesAroundTheSensorAndSeesWhatCellsBeforeHaveBecome) {
  TinyMap tiny(3, {{1, 1, 1.0F, 0.5F, true}, {2, 2, 3.0F, 0.5F, false}});
  ASSERT_EQ(tiny.map.size(), 3);
  tiny.interpolate(1, 1);
  // The ring begins at (0, 0) and runs (1, 0) (2, 0) (2, 1) (2, 2) (1, 2) (0, 2) (0, 1).
  EXPECT_FLOAT_EQ(tiny.height(1, 1), 1.0F);  // ground: untouched
  EXPECT_FLOAT_EQ(tiny.confidence(1, 1), 0.5F);
  EXPECT_FLOAT_EQ(tiny.height(0, 0), 1.0F);  // sees the centre only: 0.5·1 / 0.5
  EXPECT_FLOAT_EQ(tiny.height(1, 0), 1.0F);
  EXPECT_FLOAT_EQ(tiny.height(2, 0), 1.0F);
  EXPECT_FLOAT_EQ(tiny.height(2, 1), 2.0F);  // (0.5·1 + 0.5·3) / (0.5 + 0.5)
  // (2, 2): the mean is (0.5·1 + 0.5·3) / 1 = 2; 0.5·2 + 0.5·3 = 2.5; 0.5 − 0.5/5 = 0.4
  EXPECT_FLOAT_EQ(tiny.height(2, 2), 2.5F);
  EXPECT_FLOAT_EQ(tiny.confidence(2, 2), 0.4F);
  // (1, 2) comes after: (0.5·1 + 0.4·2.5) / (0.5 + 0.4) = 1.5 / 0.9 = 1.666667
  EXPECT_FLOAT_EQ(tiny.height(1, 2), 1.5F / 0.9F);
  EXPECT_FLOAT_EQ(tiny.height(0, 2), 1.0F);
  EXPECT_FLOAT_EQ(tiny.height(0, 1), 1.0F);
}

TEST(InterpolateTerrain, OuterRingsSeeInnerOnes) {
  TinyMap tiny(5, {{2, 2, 1.0F, 1.0F, true}, {3, 2, 0.0F, 0.5F, false}});
  tiny.interpolate(2, 2);
  // (3, 2): the mean is (1·1 + 0.5·0) / 1.5 = 2/3; 0.5 · 2/3 + 0.5 · 0 = 1/3
  EXPECT_FLOAT_EQ(tiny.height(3, 2), 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(tiny.height(4, 2), 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(tiny.height(0, 0), 0.0F);  // nothing known around it
}

TEST(Spiral, VisitsEveryCellOnceWhereverItsCentreIs) {
  for (const auto& [column, row] : std::vector<std::pair<int, int>>{
           {2, 2}, {0, 0}, {4, 1}, {2, 4}, {-1, 2}, {-3, 9}, {7, -2}}) {
    std::vector<int> visits(25);
    spiral(5, column, row, [&](int x, int y) { ++visits[static_cast<std::size_t>(y * 5 + x)]; });
    for (const int count : visits) EXPECT_EQ(count, 1) << "around " << column << ", " << row;
  }
}

/// A scan over a map of 11 × 11 cells of one metre, with the sensor over its middle.
class PaperMethod : public ::testing::Test {
 protected:
  PaperMethod() : config_(metre_grid(11)), map_(flat_map(config_)), points_(map_) {
    config_.paper_only.min_point_fraction = 0.0;
  }

  void observe() {
    const Point3f sensor{5.5F, 5.5F, 1.7F};
    paper::observe_ground({{}, {&sensor, 1}}, points_.grid(), config_, is_ground_, map_);
  }
  bool is_ground(int column, int row) const {
    return is_ground_[cell_index(map_, column, row)] == 1;
  }
  float height(int column, int row) const { return map_.height()[cell_index(map_, column, row)]; }

  Config config_;
  ElevationMap map_;
  PointsInCells points_;
  paper::GroundMask is_ground_{std::vector<std::uint8_t>(map_.cells())};
};

TEST_F(PaperMethod, ACellsOwnVarianceDecidesFromTenPointsOnAndThePatchsBelow) {
  // Within 5 m t_v is 5e-5 m²: heights of 0 and 0.02 m have a variance of 1e-4, of 0 and 0.01 m
  // 2.5e-5.
  points_.add(2, 2, {0, 0.02, 0, 0.02, 0, 0.02, 0, 0.02, 0, 0.02});
  points_.add(8, 2, {0, 0.01, 0, 0.01, 0, 0.01, 0, 0.01, 0, 0.01});
  points_.add(8, 8, {0, 0.02});
  points_.add(8, 9, {0, 0, 0, 0, 0, 0});  // the patch of (8, 8): (2 · 1e-4 + 6 · 0) / 8 = 2.5e-5
  observe();
  EXPECT_FALSE(is_ground(2, 2));
  EXPECT_TRUE(is_ground(8, 2));
  EXPECT_TRUE(is_ground(8, 8));
}

TEST_F(PaperMethod, SkipsCellsWithLessThanTheirShareOfTheExpectedPoints) {
  // 3 m away: atan(1/3) = 18.435°, / 0.4° = 46.09 points; a quarter of that is 11.5.
  config_.paper_only.min_point_fraction = 0.25;
  points_.add(8, 5, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  points_.add(2, 5, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  observe();
  EXPECT_FALSE(is_ground(8, 5));
  EXPECT_TRUE(is_ground(2, 5));
}

TEST_F(PaperMethod, PatchesGrowFromThreeToFiveCellsAtTheirDistance) {
  config_.paper_only.patch_change_distance_m = 3.0;
  points_.add(5, 6, {0.0});  // 1 m away: 3 × 3
  points_.add(5, 8, {1.0});  // two rows further, 3 m away: 5 × 5
  observe();
  EXPECT_FLOAT_EQ(height(5, 6), 0.0F);
  EXPECT_FLOAT_EQ(height(5, 8), 0.5F);  // eq. 3 over both: (1 · 0 + 1 · 1) / 2
}

TEST_F(PaperMethod, AnObstacleBelowTheMapLowersItAndOneAboveChangesNothing) {
  points_.add(2, 2, {-0.4, 0.6});
  points_.add(8, 8, {0.3, 0.9});
  observe();
  EXPECT_FLOAT_EQ(height(2, 2), -0.4F);
  EXPECT_FLOAT_EQ(map_.confidence()[cell_index(map_, 2, 2)], 0.1F);
  EXPECT_FLOAT_EQ(height(8, 8), 0.0F);
}

TEST_F(PaperMethod, ThresholdsAreThoseOfTheCellsClass) {
  is_ground_[cell_index(map_, 2, 2)] = 1;
  points_.add(2, 2, {0.299, 0.301, -3.0});
  points_.add(7, 2, {0.099, 0.101});
  BinnedPoints bins = points_.bins();
  bins.cell.push_back(7 | BinnedPoints::kOutlier);
  bins.z.push_back(-15000);
  bins.cell.push_back(BinnedPoints::kNoCell);
  bins.z.push_back(0);
  std::vector<Label> labels(7);
  std::vector<float> heights(7);
  const LabelCounts counts = paper::segment(bins, is_ground_, map_, config_, {labels, heights});
  EXPECT_EQ(labels,
            (std::vector<Label>{Label::ground, Label::obstacle, Label::ground, Label::ground,
                                Label::obstacle, Label::outlier, Label::unknown}));
  EXPECT_EQ(counts.ground, 3U);
  EXPECT_EQ(counts.obstacle, 2U);
  EXPECT_EQ(counts.outlier, 1U);
  EXPECT_EQ(counts.unknown, 1U);
  EXPECT_NEAR(heights[5], -1.5F, 1e-6F);
  EXPECT_TRUE(std::isnan(heights[6]));
}

}  // namespace
}  // namespace groundgrid
