// The kernels that work on whole blocks of points.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/kernels/point_kernels.hpp"
#include "core/stages/rasterization.hpp"
#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

constexpr float kBlockNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kBlockInfinity = std::numeric_limits<float>::infinity();

/// Points on a lattice of 1/8 m within 20 m of the origin.
PointBlock some_block() {
  std::mt19937 random(1);
  PointBlock points;
  for (float* values : {points.x, points.y, points.z})
    for (std::size_t i = 0; i < PointBlock::kMost; ++i)
      values[i] = 0.125F * (static_cast<float>(random() % 321) - 160.0F);
  return points;
}

class PointBlockKernels : public testing::OnInstructionSet {};

TEST_P(PointBlockKernels, BinBlockTakesPointsFromTheRangeOn) {
  PointBlock points = some_block();
  // 9 + 16 = 25 exactly, and the next lattice point below it.
  points.x[511] = 3.0F, points.y[511] = 4.0F, points.z[511] = 0.0F;
  points.x[510] = 3.0F, points.y[510] = 3.875F, points.z[510] = 0.0F;
  points.x[509] = kBlockNan;
  BinRule rule{100.0F, 1.0F, 100, 50.0F, 25.0F};
  rule.transform.t[0] = rule.transform.t[1] = 50.0F;
  BinBlock bins;
  bin_block(points, rule, bins);
  std::size_t near = 0;
  for (std::size_t i = 0; i < PointBlock::kMost; ++i) {
    const float range_squared =
        points.x[i] * points.x[i] + points.y[i] * points.y[i] + points.z[i] * points.z[i];
    const bool taken = range_squared >= 25.0F;
    EXPECT_EQ(bins.cell[i] != BinnedPoints::kNoCell, taken) << i;
    if (range_squared < 25.0F) ++near;
  }
  EXPECT_NE(bins.cell[511], BinnedPoints::kNoCell);
  EXPECT_EQ(bins.cell[510], BinnedPoints::kNoCell);
  EXPECT_GT(near, 1U);
}

TEST_P(PointBlockKernels, BinBlockMovesPointByPoint) {
  const PointBlock points = some_block();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.6, 0.48, 0.64)));
  T.pretranslate(Eigen::Vector3d(60.1, 59.7, 1.3));
  BinRule rule{120.0F, 4.0F, 480, 100.0F};
  rule.transform = PointTransform(T);
  BinBlock bins;
  bin_block(points, rule, bins);
  std::size_t at_borders = 0;
  for (std::size_t i = 0; i < PointBlock::kMost; ++i) {
    const Eigen::Vector3d p =
        T * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]).cast<double>();
    EXPECT_NEAR(static_cast<double>(bins.z[i]) * 1e-4, p.z(), 1e-4) << i;
    const auto cell =
        static_cast<std::uint32_t>(4.0 * p.y()) * 480U + static_cast<std::uint32_t>(4.0 * p.x());
    if (bins.cell[i] != cell) ++at_borders;
  }
  EXPECT_LE(at_borders, 1U);
}

TEST_P(PointBlockKernels, BinRecordsIsBinBlock) {
  PointBlock points = some_block();
  points.x[3] = kBlockNan;
  points.z[200] = kBlockInfinity;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.6, 0.48, 0.64)));
  T.pretranslate(Eigen::Vector3d(12.0, 13.0, 1.3));
  BinRule rule{25.0F, 4.0F, 100, 15.0F, 9.0F};
  rule.transform = PointTransform(T);
  BinBlock expected;
  bin_block(points, rule, expected);
  for (const std::size_t floats : {3U, 4U}) {
    for (const std::size_t count : {std::size_t{0}, kRecordsTogether, PointBlock::kMost}) {
      // No more records are read than there are: the next would be a fault of the heap's.
      std::vector<float> records(floats * count, kBlockNan);
      for (std::size_t i = 0; i < count; ++i) {
        records[floats * i] = points.x[i];
        records[floats * i + 1] = points.y[i];
        records[floats * i + 2] = points.z[i];
      }
      std::vector<std::uint32_t> cells(count + 1, 77);
      std::vector<std::int32_t> z(count + 1, 77);
      bin_records({records.data(), floats, count}, rule, cells.data(), z.data());
      EXPECT_TRUE(std::equal(cells.begin(), cells.end() - 1, expected.cell)) << floats;
      EXPECT_TRUE(std::equal(z.begin(), z.end() - 1, expected.z)) << floats;
      EXPECT_EQ(cells.back(), 77U);
      EXPECT_EQ(z.back(), 77);
    }
  }
}

/// A window of 5 × 5 cells of 2 m, and heights below 100 m.
constexpr BinRule kFiveCells{10.0F, 0.5F, 5, 100.0F};

struct BinnedExample {
  Point3f point;
  std::uint32_t cell;
  std::int32_t z;
};

void expect_bins(const std::vector<BinnedExample>& examples, const BinRule& rule) {
  PointBlock points;
  for (std::size_t i = 0; i < PointBlock::kMost; ++i) {
    const Point3f& p = examples[i % examples.size()].point;
    points.x[i] = p.x, points.y[i] = p.y, points.z[i] = p.z;
  }
  BinBlock bins;
  bin_block(points, rule, bins);
  for (std::size_t i = 0; i < PointBlock::kMost; ++i) {
    const BinnedExample& expected = examples[i % examples.size()];
    EXPECT_EQ(bins.cell[i], expected.cell) << i % examples.size();
    if (expected.cell == BinnedPoints::kNoCell) continue;
    EXPECT_EQ(bins.z[i], expected.z) << i % examples.size();
  }
}

TEST_P(PointBlockKernels, BinBlockTakesTheLowerBordersAndLeavesTheUpper) {
  constexpr std::uint32_t kNone = BinnedPoints::kNoCell;
  const float last = std::nextafter(10.0F, 0.0F);
  const float below_zero = -std::numeric_limits<float>::denorm_min();
  expect_bins({{{0.0F, 0.0F, 0.0F}, 0, 0},
               {{-0.0F, -0.0F, 0.0F}, 0, 0},
               {{2.0F, 0.0F, 0.0F}, 1, 0},
               {{std::nextafter(2.0F, 0.0F), 4.0F, 0.0F}, 10, 0},
               {{last, last, 0.0F}, 24, 0},
               {{10.0F, 1.0F, 0.0F}, kNone, 0},
               {{1.0F, 10.0F, 0.0F}, kNone, 0},
               {{below_zero, 1.0F, 0.0F}, kNone, 0},
               {{1.0F, below_zero, 0.0F}, kNone, 0},
               {{1.0F, 1.0F, 100.0F}, kNone, 0},
               {{1.0F, 1.0F, -100.0F}, kNone, 0},
               {{1.0F, 1.0F, 99.5F}, 0, 995'000},
               {{7.0F, 5.0F, -99.5F}, 13, -995'000}},
              kFiveCells);
}

TEST_P(PointBlockKernels, BinBlockLeavesOutWhatIsNotFinite) {
  constexpr std::uint32_t kNone = BinnedPoints::kNoCell;
  std::vector<BinnedExample> examples{{{3.0F, 3.0F, 1.0F}, 6, 10'000}};
  for (const float value : {kBlockNan, kBlockInfinity, -kBlockInfinity, 3e38F, -3e38F}) {
    examples.push_back({{value, 1.0F, 0.0F}, kNone, 0});
    examples.push_back({{1.0F, value, 0.0F}, kNone, 0});
    examples.push_back({{1.0F, 1.0F, value}, kNone, 0});
  }
  expect_bins(examples, kFiveCells);
}

TEST_P(PointBlockKernels, BinBlockRoundsHeightsToTheNearestStepAndHalvesToEvenOnes) {
  // 1/32 m are 312.5 steps, 3/32 m are 937.5 steps; 1.00004 m are 10000.4 steps.
  expect_bins({{{1.0F, 1.0F, 0.03125F}, 0, 312},
               {{1.0F, 1.0F, 0.09375F}, 0, 938},
               {{1.0F, 1.0F, -0.03125F}, 0, -312},
               {{1.0F, 1.0F, -0.09375F}, 0, -938},
               {{1.0F, 1.0F, 1.00004F}, 0, 10'000},
               {{1.0F, 1.0F, 1.00006F}, 0, 10'001},
               {{1.0F, 1.0F, -1.00006F}, 0, -10'001}},
              kFiveCells);
}

TEST_P(PointBlockKernels, BinBlockKeepsRoundedUpColumnsInTheWindow) {
  // Times 1.0000001, the last number below 5 m rounds to 5 cells.
  const float last = std::nextafter(5.0F, 0.0F);
  ASSERT_EQ(last * std::nextafter(1.0F, 2.0F), 5.0F);
  expect_bins(
      {{{last, last, 0.0F}, 24, 0}, {{last, 0.0F, 0.0F}, 4, 0}, {{0.0F, last, 0.0F}, 20, 0}},
      {5.0F, std::nextafter(1.0F, 2.0F), 5, 100.0F});
}

INSTANTIATE_TEST_SUITE_P(With, PointBlockKernels, testing::all_instruction_sets(),
                         testing::name_of);

}  // namespace
}  // namespace groundgrid
