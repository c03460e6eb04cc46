#include "core/stages/plane_hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace groundgrid {
namespace {

/// Cells of one metre, row by row; x and y from the middle of the middle cell.
class PlaneHierarchyTest : public ::testing::Test {
 protected:
  void make(int cells) {
    size = cells;
    const auto count = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
    weights.assign(count, 0.0F);
    heights.assign(count, 0.0F);
    surface.assign(count, 0.0F);
  }
  std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y + size / 2) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(x + size / 2);
  }
  void for_all(const std::function<void(int, int)>& visit) const {
    for (int y = -(size / 2); y <= size / 2; ++y)
      for (int x = -(size / 2); x <= size / 2; ++x) visit(x, y);
  }
  void set(int x, int y, double height, double weight = 1.0) {
    heights[cell(x, y)] = static_cast<float>(height);
    weights[cell(x, y)] = static_cast<float>(weight);
  }
  /// The weights as the fit asks for them.
  auto weigh() const {
    return [this](std::size_t row, const PlaneHierarchy::RowCursor&, float* row_weights) {
      const auto count = static_cast<std::ptrdiff_t>(size);
      const auto first = weights.begin() + static_cast<std::ptrdiff_t>(row) * count;
      std::copy(first, first + count, row_weights);
    };
  }
  void fit(const LocalPlane& top = {}, std::size_t level = 0) {
    TileRunner runner(2);
    PlaneHierarchy planes(size, 1.0, 2);
    planes.fit(heights, weigh(), top, level, runner);
    planes.evaluate(level, runner, surface);
  }
  double at(int x, int y) const { return static_cast<double>(surface[cell(x, y)]); }

  int size = 0;
  std::vector<float> weights;
  std::vector<float> heights;
  std::vector<float> surface;
};

TEST_F(PlaneHierarchyTest, TheHeightAtACellIsThatOfTheSurface) {
  make(61);
  for_all(
      [&](int x, int y) { set(x, y, 0.1 * x + std::sin(0.3 * y), (x + y) % 3 == 0 ? 1.0 : 0.0); });
  TileRunner runner(1);
  for (const std::size_t level : {0U, 1U}) {
    PlaneHierarchy planes(size, 1.0, 1);
    planes.fit(heights, weigh(), {}, level, runner);
    planes.evaluate(level, runner, surface);
    for_all([&](int x, int y) {
      const auto index = static_cast<std::uint32_t>(cell(x, y));
      EXPECT_NEAR(planes.height_at(level, index), surface[index], 1e-5F) << x << ' ' << y;
    });
  }
}

TEST_F(PlaneHierarchyTest, WithoutHeightsTheExpectedPlaneGoesOn) {
  make(61);
  for (const std::size_t level : {0U, 1U, 2U}) {
    fit({1.5, 0.2, -0.1}, level);
    for_all([&](int x, int y) { EXPECT_NEAR(at(x, y), 1.5 + 0.2 * x - 0.1 * y, 1e-4); });
  }
}

TEST_F(PlaneHierarchyTest, OneHeightNarrowsTheVarianceByItsShare) {
  make(5);
  set(0, 0, 1.0);
  TileRunner runner(2);
  PlaneHierarchy planes(size, 1.0, 2);
  planes.fit(heights, weigh(), {}, 0, runner);
  planes.evaluate_variance(0, surface);
  // 0.25 m² was expected, 0.0234 m² is that of the height; slopes of ± 0.1 stay.
  EXPECT_NEAR(at(0, 0), 0.25 * 0.0234 / (0.25 + 0.0234), 1e-6);
  EXPECT_NEAR(at(2, 0), at(0, 0) + 4.0 * 0.01, 1e-6);
  EXPECT_NEAR(at(-1, 2), at(0, 0) + 1.0 * 0.01 + 4.0 * 0.01, 1e-6);
}

TEST_F(PlaneHierarchyTest, OneHeightMovesTheExpectedPlaneByItsShare) {
  make(5);  // one block
  set(0, 0, 1.0);
  fit();
  // Expected: 0 ± 0.5 m. Seen: 1 ± hypot(0.03, 0.03 · 5) m, a variance of 0.0234 m².
  const double share = (1.0 / 0.0234) / (1.0 / 0.0234 + 1.0 / 0.25);
  EXPECT_NEAR(at(0, 0), share, 1e-5);
  // Only the height: a cell in the middle says nothing of the slope.
  EXPECT_NEAR(at(2, -2), share, 1e-5);
}

TEST_F(PlaneHierarchyTest, AHeightBesideTheMiddleTiltsThePlane) {
  make(5);
  set(2, 0, 1.0);
  fit();
  // Of height h and slope s: f (1 - h - 2 s) = h / 0.25 and 2 f (1 - h - 2 s) = s / 0.01.
  const double f = 1.0 / 0.0234;
  const double rest = 1.0 / (1.0 + f * (0.25 + 4.0 * 0.01));
  const double h = 0.25 * f * rest;
  const double s = 0.02 * f * rest;
  EXPECT_NEAR(at(0, 0), h, 1e-5);
  EXPECT_NEAR(at(2, 0), h + 2.0 * s, 1e-5);
  EXPECT_NEAR(at(0, 2), h, 1e-5);
}

TEST_F(PlaneHierarchyTest, ManyCellsOfABlockSayNoMoreThanEight) {
  make(5);
  for_all([&](int x, int y) { set(x, y, 1.0); });
  fit();
  const double f = 8.0 / 0.0234;
  EXPECT_NEAR(at(0, 0), f / (f + 4.0), 1e-5);
}

TEST_F(PlaneHierarchyTest, WeightsCount) {
  make(5);
  set(0, 0, 1.0, 0.5);
  fit();
  EXPECT_NEAR(at(0, 0), (0.5 / 0.0234) / (0.5 / 0.0234 + 4.0), 1e-5);
}

TEST_F(PlaneHierarchyTest, AGapIsFilledAlongTheSlope) {
  make(121);
  for_all([&](int x, int y) {
    if (std::abs(x) > 10 || std::abs(y) > 10) set(x, y, 0.3 * x + 0.1 * y);
  });
  fit();
  for_all([&](int x, int y) { EXPECT_NEAR(at(x, y), 0.3 * x + 0.1 * y, 0.05) << x << ' ' << y; });
}

TEST_F(PlaneHierarchyTest, AStepStaysASteepPlace) {
  make(121);
  for_all([&](int x, int y) { set(x, y, x < 0 ? 0.0 : 1.0); });
  fit();
  EXPECT_NEAR(at(-20, 0), 0.0, 0.02);
  EXPECT_NEAR(at(20, 0), 1.0, 0.02);
}

TEST_F(PlaneHierarchyTest, AQuarterTurnTurnsTheSurface) {
  make(61);
  const auto height = [](int x, int y) { return 0.3 * std::sin(0.2 * x) + 0.02 * y * std::cos(x); };
  const auto known = [](int x, int y) { return (7 * x + 3 * y) % 5 == 0; };
  for_all([&](int x, int y) {
    if (known(x, y)) set(x, y, height(x, y));
  });
  fit({0.1, 0.05, -0.02});
  const std::vector<float> straight = surface;
  make(61);
  for_all([&](int x, int y) {
    if (known(x, y)) set(-y, x, height(x, y));
  });
  fit({0.1, 0.02, 0.05});
  for_all([&](int x, int y) {
    EXPECT_NEAR(at(-y, x), static_cast<double>(straight[cell(x, y)]), 1e-4);
  });
}

TEST_F(PlaneHierarchyTest, LevelsAreAsWideAsAskedFor) {
  const PlaneHierarchy planes(365, 0.33, 1);  // 1.65 m, 4.95 m, 14.85 m, 44.55 m, 133.65 m
  EXPECT_EQ(planes.level_of(0.0), 0U);
  EXPECT_EQ(planes.level_of(1.7), 1U);
  EXPECT_EQ(planes.level_of(4.9), 1U);
  EXPECT_EQ(planes.level_of(5.0), 2U);
  EXPECT_EQ(planes.level_of(1e6), 4U);
}

}  // namespace
}  // namespace groundgrid
