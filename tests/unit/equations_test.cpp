// Eq. 1 to 8 of the paper against values worked out by hand.
#include "core/method/equations.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace groundgrid {
namespace {

/// Eq. 5 and 6.
CellEstimate fused(const CellEstimate& known, float h, float q) {
  return {fused_height(known, h, q), fused_confidence(known.confidence, q)};
}

TEST(VarianceThreshold, GrowsWithDistanceAndHasAMinimum) {
  const Config paper = Config::paper();
  // t_v = d_sf · d = 1e-5 · 10 = 1e-4; 1e-5 · 60 = 6e-4
  EXPECT_DOUBLE_EQ(variance_threshold(10.0, paper), 1e-4);
  EXPECT_DOUBLE_EQ(variance_threshold(60.0, paper), 6e-4);
  // 1e-5 · 3 = 3e-5 is below the minimum 5 · d_sf = 5e-5, which is reached at 5 m.
  EXPECT_DOUBLE_EQ(variance_threshold(3.0, paper), 5e-5);
  EXPECT_DOUBLE_EQ(variance_threshold(0.0, paper), 5e-5);
  EXPECT_DOUBLE_EQ(variance_threshold(5.0, paper), 5e-5);
}

TEST(ExpectedPoints, IsTheCellsAngleOverThePointAngle) {
  const Config paper = Config::paper();  // R = 0.33 m, d_pv = 0.4°
  // d = R: atan(1) = 45°, 45 / 0.4 = 112.5
  EXPECT_NEAR(expected_points(0.33, paper), 112.5, 1e-9);
  // d = R·√3: atan(1/√3) = 30°, 30 / 0.4 = 75
  EXPECT_NEAR(expected_points(0.33 * std::sqrt(3.0), paper), 75.0, 1e-9);
  // d = 20: atan(0.0165) = 0.0165 − 0.0165³/3 = 0.01649850 rad = 0.945295°, / 0.4 = 2.36324
  EXPECT_NEAR(expected_points(20.0, paper), 2.36324, 1e-5);
  // d = 0: 90°, 90 / 0.4 = 225
  EXPECT_NEAR(expected_points(0.0, paper), 225.0, 1e-9);
}

TEST(GroundElevation, WeighsLowestHeightsByPoints) {
  // Eq. 3: points 3 and 1, lowest 0.2 and 0.6: (0.6 + 0.6) / 4
  EXPECT_FLOAT_EQ(ground_elevation(3.0F * 0.2F + 1.0F * 0.6F, 4.0F), 0.3F);
}

TEST(ObservationConfidence, IsThePatchsPointsOverTheScaleFromZeroToOne) {
  const Config paper = Config::paper();  // s = 20
  EXPECT_FLOAT_EQ(observation_confidence(0.0F, paper), 0.0F);
  EXPECT_FLOAT_EQ(observation_confidence(5.0F, paper), 0.25F);  // 5 / 20
  EXPECT_FLOAT_EQ(observation_confidence(20.0F, paper), 1.0F);
  EXPECT_FLOAT_EQ(observation_confidence(50.0F, paper), 1.0F);  // 2.5, clamped
}

TEST(Fusion, WeighsHeightsByConfidence) {
  // Eq. 5: (0.25·2 + 0.5·1) / (0.25 + 0.5) = 1 / 0.75 = 1.333333
  // Eq. 6: (0.25/2 + 0.5) / 2 = 0.3125
  const CellEstimate estimate = fused({1.0F, 0.5F}, 2.0F, 0.25F);
  EXPECT_FLOAT_EQ(estimate.height, 4.0F / 3.0F);
  EXPECT_FLOAT_EQ(estimate.confidence, 0.3125F);
}

TEST(Fusion, TakesTheObservationWhereNothingIsKnown) {
  // (0.5·2 + 0·7) / 0.5 = 2; (0.5/2 + 0) / 2 = 0.125
  const CellEstimate estimate = fused({7.0F, 0.0F}, 2.0F, 0.5F);
  EXPECT_FLOAT_EQ(estimate.height, 2.0F);
  EXPECT_FLOAT_EQ(estimate.confidence, 0.125F);
}

TEST(Fusion, KeepsTheHeightWhereNeitherHasConfidence) {
  const CellEstimate estimate = fused({7.0F, 0.0F}, 2.0F, 0.0F);
  EXPECT_FLOAT_EQ(estimate.height, 7.0F);
  EXPECT_FLOAT_EQ(estimate.confidence, 0.0F);
}

TEST(Fusion, RepeatedFullObservationsLeadToHalfConfidence) {
  // Eq. 6 with q = 1: c = (0.5 + c) / 2 has its fixed point at 0.5.
  CellEstimate estimate{0.0F, 0.0F};
  for (int scan = 0; scan < 40; ++scan) estimate = fused(estimate, 1.0F, 1.0F);
  EXPECT_NEAR(estimate.confidence, 0.5F, 1e-6F);
  EXPECT_NEAR(estimate.height, 1.0F, 1e-6F);
}

TEST(LoweredByObstacle, LowersTheGroundAndAddsALittleConfidence) {
  const CellEstimate lowered = lowered_by_obstacle({1.0F, 0.2F}, 0.4F);
  EXPECT_FLOAT_EQ(lowered.height, 0.4F);
  EXPECT_FLOAT_EQ(lowered.confidence, 0.3F);  // min(0.2 + 0.1, 0.5)
  EXPECT_FLOAT_EQ(lowered_by_obstacle({1.0F, 0.45F}, 0.4F).confidence, 0.5F);  // min(0.55, 0.5)
  EXPECT_FLOAT_EQ(lowered_by_obstacle({1.0F, 0.7F}, 0.4F).confidence, 0.5F);   // min(0.8, 0.5)
}

TEST(LoweredByObstacle, NeverRaisesTheGround) {
  for (const float elevation : {1.0F, 1.5F}) {
    const CellEstimate kept = lowered_by_obstacle({1.0F, 0.2F}, elevation);
    EXPECT_FLOAT_EQ(kept.height, 1.0F);
    EXPECT_FLOAT_EQ(kept.confidence, 0.2F);
  }
}

TEST(InterpolatedHeight, MixesTheNeighbourhoodsMeanWithTheKnownHeight) {
  // Eq. 7: ΣC = 2, Σ(C∘G) = 3: (1 − 0.25) · 3/2 + 0.25 · 2 = 1.125 + 0.5 = 1.625
  EXPECT_FLOAT_EQ(interpolated_height({2.0F, 0.25F}, 2.0F, 3.0F), 1.625F);
  EXPECT_FLOAT_EQ(interpolated_height({2.0F, 0.0F}, 2.0F, 3.0F), 1.5F);
  EXPECT_FLOAT_EQ(interpolated_height({2.0F, 1.0F}, 2.0F, 3.0F), 2.0F);
}

TEST(InterpolatedHeight, StaysWhereNothingAroundIsKnown) {
  EXPECT_FLOAT_EQ(interpolated_height({2.0F, 0.0F}, 0.0F, 0.0F), 2.0F);  // 0/0
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

}  // namespace
}  // namespace groundgrid
