#include "core/stages/surface_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace groundgrid {
namespace {

/// A block of 5 × 5 cells of one metre with a height of 1 m in its middle, where 0 ± 0.5 m was
/// expected. The height is known to hypot(0.03, 0.03 · 5) m, so that the plane there lies at
/// 0.25 / (0.25 + 0.0234) m with a variance of 0.25 · 0.0234 / (0.25 + 0.0234) m².
constexpr std::uint32_t kMiddle = 12;
constexpr double kPlaneHeight_m = 0.25 / (0.25 + 0.0234);
constexpr double kPlaneVariance_m2 = 0.25 * 0.0234 / (0.25 + 0.0234);

class OneBlock : public ::testing::Test {
 protected:
  OneBlock() : fit(5, 1.0, runner), heights(25, 0.0F), deviations(25) {
    heights[kMiddle] = 1.0F;
    forget();
    fit.heights()[kMiddle] = 1.0F;
    fit.accept_all();
    fit.fit(heights, {});
  }
  void forget() { std::fill(fit.heights().begin(), fit.heights().end(), kUnknownHeight); }
  double deviation(std::size_t cell) {
    fit.standard_deviation(heights, deviations);
    return static_cast<double>(deviations[cell]);
  }

  TileRunner runner{1};
  SurfaceFit fit;
  std::vector<float> heights;
  std::vector<float> deviations;
};

TEST_F(OneBlock, OfGroundIsThePlanesAndTheDistanceToIt) {
  const double off = 1.0 - kPlaneHeight_m;
  EXPECT_NEAR(deviation(kMiddle), std::sqrt(1.2 * kPlaneVariance_m2 + off * off), 1e-5);
}

TEST_F(OneBlock, ElsewhereTheDistanceToWidePlanesComesOnTop) {
  // In the corner two metres east and north the slopes, ± 0.1 each, add 2² · 0.1² m² twice. Here
  // the finest planes are the wide ones too.
  heights[24] = static_cast<float>(kPlaneHeight_m - 0.3);
  const double variance = 1.2 * (kPlaneVariance_m2 + 0.08) + 2.0 * 0.3 * 0.3;
  EXPECT_NEAR(deviation(24), std::sqrt(variance), 1e-5);
}

TEST_F(OneBlock, TheSecondAskingSaysTheSame) {
  const double first = deviation(kMiddle);
  EXPECT_EQ(deviation(kMiddle), first);
}

TEST_F(OneBlock, UnknownHeightsCountForNothing) {
  EXPECT_TRUE(fit.is_ground(kMiddle));
  forget();
  fit.accept_all();
  EXPECT_FALSE(fit.is_ground(kMiddle));
  fit.fit(heights, {});
  EXPECT_NEAR(deviation(kMiddle), std::sqrt(1.2 * 0.25 + 2.0), 1e-5);
}

TEST(SurfaceFit, DeviationsGrowWithTheDistanceFromWhatIsKnown) {
  constexpr int kSide = 61;
  TileRunner runner(3);
  SurfaceFit fit(kSide, 0.33, runner);
  std::vector<float> heights(std::size_t{kSide} * kSide, 0.0F);
  for (std::size_t cell = 0; cell < heights.size(); ++cell)
    fit.heights()[cell] = cell % kSide < 10 ? 0.0F : kUnknownHeight;
  fit.accept_all();
  fit.fit(heights, {});
  std::vector<float> deviations(heights.size());
  fit.standard_deviation(heights, deviations);
  const std::size_t row = std::size_t{30} * kSide;
  for (std::size_t column = 10; column < 60; column += 5)
    EXPECT_LT(deviations[row + column], deviations[row + column + 5]) << column;
}

}  // namespace
}  // namespace groundgrid
