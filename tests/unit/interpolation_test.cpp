// Paper III-E: eq. 7 and 8 and the spiral.
#include "core/interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;

TEST(InterpolatedHeight, MixesTheNeighbourhoodsMeanWithTheKnownHeight) {
  // Eq. 7: ΣC = 2, Σ(C∘G) = 3: (1 − 0.25) · 3/2 + 0.25 · 2 = 1.125 + 0.5 = 1.625
  EXPECT_FLOAT_EQ(interpolated_height(2.0F, 0.25F, 2.0F, 3.0F), 1.625F);
  EXPECT_FLOAT_EQ(interpolated_height(2.0F, 0.0F, 2.0F, 3.0F), 1.5F);
  EXPECT_FLOAT_EQ(interpolated_height(2.0F, 1.0F, 2.0F, 3.0F), 2.0F);
}

TEST(InterpolatedHeight, StaysWhereNothingAroundIsKnown) {
  EXPECT_FLOAT_EQ(interpolated_height(2.0F, 0.0F, 0.0F, 0.0F), 2.0F);  // 0/0
}

TEST(DecayedConfidence, LosesItsShare) {
  EXPECT_FLOAT_EQ(decayed_confidence(0.5F, 5.0F), 0.4F);  // 0.5 − 0.5/5
  EXPECT_FLOAT_EQ(decayed_confidence(0.5F, 1.0F), 0.0F);
  EXPECT_FLOAT_EQ(decayed_confidence(0.0F, 5.0F), 0.0F);
}

TEST(DecayedConfidence, IsForgottenBeforeItBecomesSubnormal) {
  float confidence = 1.0F;
  int scans = 0;
  for (; confidence > 0.0F && scans < 1000; ++scans) {
    confidence = decayed_confidence(confidence, 5.0F);
    ASSERT_NE(std::fpclassify(confidence), FP_SUBNORMAL);
  }
  EXPECT_LT(scans, 400);  // 0.8^n < 1e-30 from n = 310 on
  EXPECT_GT(scans, 250);
}

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

  float height(int column, int row) { return map.height()[cell_index(map, column, row)]; }
  float confidence(int column, int row) { return map.confidence()[cell_index(map, column, row)]; }
};

TEST(Interpolate, GoesAroundTheSensorAndSeesWhatCellsBeforeHaveBecome) {
  TinyMap tiny(3, {{1, 1, 1.0F, 0.5F, true}, {2, 2, 3.0F, 0.5F, false}});
  ASSERT_EQ(tiny.map.size(), 3);
  interpolate(tiny.is_ground, 1, 1, tiny.config, tiny.map);
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

TEST(Interpolate, OuterRingsSeeInnerOnes) {
  TinyMap tiny(5, {{2, 2, 1.0F, 1.0F, true}, {3, 2, 0.0F, 0.5F, false}});
  interpolate(tiny.is_ground, 2, 2, tiny.config, tiny.map);
  // (3, 2): the mean is (1·1 + 0.5·0) / 1.5 = 2/3; 0.5 · 2/3 + 0.5 · 0 = 1/3
  EXPECT_FLOAT_EQ(tiny.height(3, 2), 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(tiny.height(4, 2), 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(tiny.height(0, 0), 0.0F);  // nothing known around it
}

TEST(Interpolate, VisitsEveryCellOnceWhereverTheSensorIs) {
  for (const auto& [column, row] : std::vector<std::pair<int, int>>{
           {2, 2}, {0, 0}, {4, 1}, {2, 4}, {-1, 2}, {-3, 9}, {7, -2}}) {
    TinyMap tiny(5, {});
    for (float& confidence : tiny.map.confidence()) confidence = 0.5F;
    interpolate(tiny.is_ground, column, row, tiny.config, tiny.map);
    for (const float confidence : tiny.map.confidence())
      EXPECT_FLOAT_EQ(confidence, 0.4F) << "sensor in cell " << column << ", " << row;
  }
}

}  // namespace
}  // namespace groundgrid
