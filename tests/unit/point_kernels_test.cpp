#include "core/kernels/point_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/stages/rasterization.hpp"
#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

constexpr std::uint32_t kNoCell = BinnedPoints::kNoCell;
constexpr std::uint32_t kOutlier = BinnedPoints::kOutlier;
constexpr auto kFloatStep_m = static_cast<float>(CellStatistics::kStep_m);
constexpr std::uint32_t kPointCells = 40;

struct SomePoints {
  std::vector<std::uint32_t> cells{};
  std::vector<std::int32_t> z{};

  [[nodiscard]] BinnedRange range() const { return {cells.data(), z.data(), cells.size()}; }
};

/// Neighbours often in one cell, some outliers, some points without a cell.
SomePoints some_points(std::size_t count, std::int32_t highest, unsigned seed = 1) {
  std::mt19937 random(seed);
  SomePoints points;
  std::uint32_t cell = 7;
  for (std::size_t i = 0; i < count; ++i) {
    if (random() % 2 == 0) cell = static_cast<std::uint32_t>(random() % kPointCells);
    const auto kind = random() % 8;
    points.cells.push_back(kind == 0 ? kNoCell : kind == 1 ? cell + kOutlier : cell);
    const auto span = static_cast<std::uint32_t>(2 * highest + 1);
    points.z.push_back(static_cast<std::int32_t>(random() % span) - highest);
  }
  return points;
}

class PointKernels : public testing::OnInstructionSet {};

void expect_moments(const CellStatistics& cell, const CellStatistics& expected) {
  EXPECT_EQ(cell.sum, expected.sum);
  EXPECT_EQ(cell.sum_squares, expected.sum_squares);
  EXPECT_EQ(cell.min, expected.min);
  EXPECT_EQ(cell.max, expected.max);
  EXPECT_EQ(cell.count, expected.count);
}

TEST_P(PointKernels, AddPointsSumsThoseOfTheBand) {
  for (std::size_t count = 0; count <= 150; ++count) {
    const SomePoints points = some_points(count, 5'000'000);
    for (const CellBand band : {CellBand{0, kPointCells}, CellBand{5, 23}, CellBand{9, 9}}) {
      std::vector<CellStatistics> expected(kPointCells);
      for (std::size_t i = 0; i < count; ++i) {
        if (points.cells[i] < band.begin || points.cells[i] >= band.end) continue;
        CellStatistics& cell = expected[points.cells[i]];
        const std::int64_t z = points.z[i];
        cell.sum += z;
        cell.sum_squares += static_cast<std::uint64_t>(z * z);
        cell.min = std::min(cell.min, points.z[i]);
        cell.max = std::max(cell.max, points.z[i]);
        ++cell.count;
      }
      std::vector<CellStatistics> statistics(kPointCells);
      std::vector<std::uint8_t> is_occupied(kPointCells);
      add_points(points.range(), band, statistics.data(), is_occupied.data());
      for (std::size_t cell = 0; cell < kPointCells; ++cell) {
        SCOPED_TRACE(::testing::Message() << "cell " << cell << " of " << count << " points");
        expect_moments(statistics[cell], expected[cell]);
        EXPECT_EQ(is_occupied[cell], expected[cell].count > 0 ? 1 : 0);
      }
    }
  }
}

TEST_P(PointKernels, AddPointsAddsToWhatIsThere) {
  SomePoints points{{1, 1, 1, kNoCell, 1, 1 + kOutlier}, {3, -4, -4, 9, 2'000'000, -99}};
  std::vector<CellStatistics> statistics(2);
  statistics[1] = {10, 50, 4, 6, 2};
  std::vector<std::uint8_t> is_occupied(2);
  add_points(points.range(), {0, 2}, statistics.data(), is_occupied.data());
  // 10 + 3 - 4 - 4 + 2e6; 50 + 9 + 16 + 16 + 4e12
  expect_moments(statistics[1], {2'000'005, 4'000'000'000'091U, -4, 2'000'000, 6});
  expect_moments(statistics[0], {});
  EXPECT_EQ(is_occupied, (std::vector<std::uint8_t>{0, 1}));
}

TEST_P(PointKernels, FindDeepIsPointByPoint) {
  std::vector<float> heights(kPointCells);
  for (std::size_t cell = 0; cell < kPointCells; ++cell)
    heights[cell] = 0.03F * static_cast<float>(cell) - 0.5F;
  for (std::size_t count = 0; count <= 150; ++count) {
    const SomePoints points = some_points(count, 10'000);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < count; ++i)
      if (points.cells[i] < kPointCells &&
          heights[points.cells[i]] - static_cast<float>(points.z[i]) * kFloatStep_m >= 0.25F)
        expected.push_back(i);
    std::vector<std::uint32_t> found(count + kSpareIndices);
    found.resize(find_deep(points.range(), {heights.data(), 0.25F}, found.data()));
    EXPECT_EQ(found, expected) << count;
  }
}

TEST_P(PointKernels, FindDeepTakesPointsExactlySoDeep) {
  const std::vector<float> heights{0.5F};
  const SomePoints points{{0, 0, 0, kNoCell, kOutlier}, {0, 1, -1, -9999, -9999}};
  std::vector<std::uint32_t> found(5 + kSpareIndices);
  found.resize(find_deep(points.range(), {heights.data(), 0.5F}, found.data()));
  EXPECT_EQ(found, (std::vector<std::uint32_t>{0, 2}));
}

struct ColumnPoints {
  std::vector<std::uint32_t> cells{};
  std::vector<std::int32_t> above{};
};

ColumnPoints columns_of(const SomePoints& points, const ColumnRule& rule) {
  ColumnPoints found;
  found.cells.resize(points.cells.size() + kSpareIndices);
  found.above.resize(points.cells.size() + kSpareIndices);
  const std::size_t number =
      select_columns(points.range(), rule, found.cells.data(), found.above.data());
  found.cells.resize(number);
  found.above.resize(number);
  return found;
}

TEST_P(PointKernels, SelectColumnsIsPointByPoint) {
  std::vector<std::int32_t> heights(kPointCells);
  for (std::size_t cell = 0; cell < kPointCells; ++cell)
    heights[cell] = static_cast<std::int32_t>(cell) * 31 - 400;
  for (std::size_t count = 0; count <= 150; ++count) {
    const SomePoints points = some_points(count, 4000);
    for (const CellBand band : {CellBand{0, kPointCells}, CellBand{5, 23}}) {
      const ColumnRule rule{heights.data(), band, 500, 800, 1500, 3000};
      ColumnPoints expected;
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t cell = points.cells[i];
        if (cell < band.begin || cell >= band.end) continue;
        const std::int32_t up = points.z[i] - heights[cell];
        if ((up <= -500 || up >= 800) && (up <= 1500 || up >= 3000)) continue;
        expected.cells.push_back(cell);
        expected.above.push_back(up);
      }
      const ColumnPoints found = columns_of(points, rule);
      EXPECT_EQ(found.cells, expected.cells) << count;
      EXPECT_EQ(found.above, expected.above) << count;
    }
  }
}

TEST_P(PointKernels, SelectColumnsLeavesOutTheLimitsThemselves) {
  const std::vector<std::int32_t> heights{0, 100};
  const ColumnRule rule{heights.data(), {1, 2}, 5, 8, 15, 30};
  SomePoints points;
  for (const std::int32_t up : {-6, -5, -4, 0, 7, 8, 9, 14, 15, 16, 29, 30, 31}) {
    points.cells.push_back(1);
    points.z.push_back(100 + up);
  }
  for (const std::uint32_t cell : {0U, kNoCell, 1 + kOutlier}) {
    points.cells.push_back(cell);
    points.z.push_back(100);
  }
  const ColumnPoints found = columns_of(points, rule);
  EXPECT_EQ(found.above, (std::vector<std::int32_t>{-4, 0, 7, 16, 29}));
  EXPECT_EQ(found.cells, std::vector<std::uint32_t>(5, 1));
}

struct PointLabels {
  LabelCounts counts{};
  std::vector<Label> labels{};
  std::vector<float> above{};
  std::vector<std::uint32_t> outliers{};
};

PointLabels labels_of(const SomePoints& points, const std::vector<float>& limits) {
  const std::size_t count = points.cells.size();
  PointLabels found{{},
                    std::vector<Label>(count, Label::outlier),
                    std::vector<float>(count, 99.0F),
                    std::vector<std::uint32_t>(count + kSpareIndices)};
  found.counts = label_points(points.range(), limits.data(), found.labels.data(),
                              found.above.data(), found.outliers.data());
  found.outliers.resize(found.counts.outlier);
  return found;
}

TEST_P(PointKernels, LabelPointsIsPointByPoint) {
  std::vector<float> limits;
  for (std::size_t cell = 0; cell < kPointCells; ++cell) {
    limits.push_back(0.03F * static_cast<float>(cell) - 0.6F);
    limits.push_back(0.01F * static_cast<float>(cell));
  }
  for (std::size_t count = 0; count <= 150; ++count) {
    SCOPED_TRACE(count);
    const SomePoints points = some_points(count, 10'000);
    const PointLabels found = labels_of(points, limits);
    LabelCounts expected;
    std::vector<std::uint32_t> outliers;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t cell = points.cells[i];
      if (cell >= kPointCells) {
        // Those of outliers are the caller's.
        if (cell == kNoCell) {
          EXPECT_EQ(found.labels[i], Label::unknown);
          EXPECT_TRUE(std::isnan(found.above[i]));
        } else {
          outliers.push_back(i);
        }
        ++(cell == kNoCell ? expected.unknown : expected.outlier);
        continue;
      }
      const float above = static_cast<float>(points.z[i]) * kFloatStep_m - limits[2 * cell];
      const bool ground = above <= limits[2 * cell + 1];
      EXPECT_EQ(found.above[i], above);
      EXPECT_EQ(found.labels[i], ground ? Label::ground : Label::obstacle);
      ++(ground ? expected.ground : expected.obstacle);
    }
    EXPECT_EQ(found.outliers, outliers);
    EXPECT_EQ(found.counts.ground, expected.ground);
    EXPECT_EQ(found.counts.obstacle, expected.obstacle);
    EXPECT_EQ(found.counts.outlier, expected.outlier);
    EXPECT_EQ(found.counts.unknown, expected.unknown);
  }
}

TEST_P(PointKernels, LabelPointsHoldsThresholdsReachedForGround) {
  // 0.25 m above -0.25 m is a threshold that a point reaches exactly.
  const std::vector<float> limits{0.0F, 0.0F, -0.25F, 0.25F};
  const SomePoints points{{1, 1, 1, 0, 0}, {0, 1, -1, 0, 1}};
  EXPECT_EQ(labels_of(points, limits).labels,
            (std::vector<Label>{Label::ground, Label::obstacle, Label::ground, Label::ground,
                                Label::obstacle}));
}

TEST_P(PointKernels, LabelPointsFindsOutliersAndUnknownPointsInTheTail) {
  SomePoints points{std::vector<std::uint32_t>(64, 0), std::vector<std::int32_t>(64, 0)};
  points.cells.insert(points.cells.end(), {kOutlier, kNoCell, 0});
  points.z.insert(points.z.end(), {-5, -5, 20'000});
  const PointLabels found = labels_of(points, {0.0F, 0.1F});
  EXPECT_EQ(found.outliers, std::vector<std::uint32_t>{64});
  EXPECT_EQ(found.counts.ground, 64U);
  EXPECT_EQ(found.counts.obstacle, 1U);
  EXPECT_EQ(found.counts.outlier, 1U);
  EXPECT_EQ(found.counts.unknown, 1U);
  EXPECT_EQ(found.labels[65], Label::unknown);
  EXPECT_TRUE(std::isnan(found.above[65]));
  EXPECT_EQ(found.labels[66], Label::obstacle);
  EXPECT_FLOAT_EQ(found.above[66], 2.0F);
}

INSTANTIATE_TEST_SUITE_P(With, PointKernels, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
