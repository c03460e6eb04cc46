#include "core/kernels/plane_kernels.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

/// Between -1 and 1.
class SignedNumbers {
 public:
  float operator()() { return static_cast<float>(random_() % 2001) / 1000.0F - 1.0F; }

 private:
  std::mt19937 random_{1};
};

class PlaneKernels : public testing::OnInstructionSet {};

TEST_P(PlaneKernels, AddRowsAddsWeightedSumsToTheirColumns) {
  SignedNumbers number;
  for (std::size_t rows = 1; rows <= CellRows::kMost; ++rows)
    for (std::size_t count = 0; count <= 70; ++count) {
      std::vector<std::vector<float>> weights(rows), heights(rows);
      CellRows cells{rows, {}, {}, {}};
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < count; ++i) {
          // Stretches without weight, wherever vectors begin, where the height may be anything.
          const bool known = (i / 20) % 2 == 0 && number() > 0.0F;
          weights[row].push_back(known ? 1.0F + 0.5F * number() : 0.0F);
          heights[row].push_back(known ? 3.0F * number() : 1e30F);
        }
        cells.weights[row] = weights[row].data();
        cells.heights[row] = heights[row].data();
        cells.y[row] = 0.33F * static_cast<float>(row) - 0.5F;
      }
      ColumnSums sums;
      sums.resize(count);
      for (std::vector<float>* sum : {&sums.w, &sums.wy, &sums.wyy, &sums.z, &sums.zy})
        for (float& value : *sum) value = number();
      const ColumnSums before = sums;
      add_rows(cells, count, sums);
      for (std::size_t i = 0; i < count; ++i) {
        SCOPED_TRACE(::testing::Message() << i << " of " << count << ", rows: " << rows);
        double w = 0.0, wy = 0.0, wyy = 0.0, z = 0.0, zy = 0.0;
        for (std::size_t row = 0; row < rows; ++row) {
          const double weight = static_cast<double>(weights[row][i]);
          const double y = static_cast<double>(cells.y[row]);
          const double height = static_cast<double>(heights[row][i]);
          w += weight, wy += weight * y, wyy += weight * y * y;
          z += weight * height, zy += weight * height * y;
        }
        const auto added = [i](const std::vector<float>& after, const std::vector<float>& first) {
          return static_cast<double>(after[i]) - static_cast<double>(first[i]);
        };
        EXPECT_NEAR(added(sums.w, before.w), w, 1e-5);
        EXPECT_NEAR(added(sums.wy, before.wy), wy, 1e-5);
        EXPECT_NEAR(added(sums.wyy, before.wyy), wyy, 1e-5);
        EXPECT_NEAR(added(sums.z, before.z), z, 1e-5);
        EXPECT_NEAR(added(sums.zy, before.zy), zy, 1e-5);
      }
    }
}

TEST_P(PlaneKernels, SumColumnsSumsEachBlocksColumns) {
  constexpr int kBlockCells = 5;
  constexpr int kBefore = 2;
  constexpr double kSize = 0.5;
  constexpr std::size_t kRow = 3;
  SignedNumbers number;
  for (std::size_t columns_count = 4; columns_count <= 44; ++columns_count) {
    const std::size_t count = (columns_count + kBefore + kBlockCells - 1) / kBlockCells;
    ColumnSums columns;
    columns.resize(columns_count);
    for (std::size_t i = 0; i < columns_count; ++i) {
      // Nothing is known of the third block.
      if ((i + kBefore) / kBlockCells == 2) continue;
      columns.w[i] = 2.0F + number();
      for (std::vector<float>* sum : {&columns.wy, &columns.wyy, &columns.z, &columns.zy})
        (*sum)[i] = number();
    }
    BlockSums sums;
    sums.resize(kRow + count + 1);
    for (std::vector<float>* sum :
         {&sums.w, &sums.x, &sums.y, &sums.xx, &sums.xy, &sums.yy, &sums.z, &sums.xz, &sums.yz})
      std::fill(sum->begin(), sum->end(), -7.0F);
    sum_columns(columns, kBlockCells, kBefore, static_cast<float>(kSize), sums, kRow, count);
    for (std::size_t block = 0; block < count; ++block) {
      SCOPED_TRACE(::testing::Message() << "block " << block << " of columns " << columns_count);
      double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, z = 0, xz = 0, yz = 0;
      for (int i = 0; i < kBlockCells; ++i) {
        const int at = static_cast<int>(block) * kBlockCells - kBefore + i;
        if (at < 0 || at >= static_cast<int>(columns_count)) continue;
        const auto column = static_cast<std::size_t>(at);
        const double in_x = (i - 2) * kSize;  // from the middle of five
        w += static_cast<double>(columns.w[column]);
        x += static_cast<double>(columns.w[column]) * in_x;
        xx += static_cast<double>(columns.w[column]) * in_x * in_x;
        y += static_cast<double>(columns.wy[column]);
        xy += static_cast<double>(columns.wy[column]) * in_x;
        yy += static_cast<double>(columns.wyy[column]);
        z += static_cast<double>(columns.z[column]);
        xz += static_cast<double>(columns.z[column]) * in_x;
        yz += static_cast<double>(columns.zy[column]);
      }
      const std::size_t to = kRow + block;
      EXPECT_NEAR(static_cast<double>(sums.w[to]), w, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.x[to]), x, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.y[to]), y, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.xx[to]), xx, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.xy[to]), xy, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.yy[to]), yy, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.z[to]), z, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.xz[to]), xz, 1e-5);
      EXPECT_NEAR(static_cast<double>(sums.yz[to]), yz, 1e-5);
    }
    EXPECT_EQ(sums.w[kRow - 1], -7.0F);
    EXPECT_EQ(sums.yz[kRow + count], -7.0F);
  }
}

constexpr BlockScatter kBlockScatter{0.04F, 0.01F, 0.0025F, 12.0F};

BlockPlanes some_planes(std::size_t count) {
  SignedNumbers number;
  BlockPlanes planes;
  planes.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    planes.height[i] = 3.0F * number();
    planes.slope_x[i] = 0.3F * number();
    planes.slope_y[i] = 0.3F * number();
    planes.variance_height[i] = 0.05F + 0.01F * number();
    planes.variance_x[i] = 0.02F + 0.01F * number();
    planes.variance_y[i] = 0.02F + 0.01F * number();
  }
  return planes;
}

TEST_P(PlaneKernels, CorrectRowWithoutCellsLeavesThePlanes) {
  for (std::size_t count = 1; count <= 40; ++count) {
    BlockSums sums;
    sums.resize(count);
    BlockPlanes planes = some_planes(count);
    const BlockPlanes before = planes;
    correct_row(sums, kBlockScatter, planes, 0, count);
    EXPECT_EQ(planes.height, before.height);
    EXPECT_EQ(planes.slope_x, before.slope_x);
    EXPECT_EQ(planes.slope_y, before.slope_y);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_FLOAT_EQ(planes.variance_height[i], before.variance_height[i]);
      EXPECT_FLOAT_EQ(planes.variance_x[i], before.variance_x[i]);
      EXPECT_FLOAT_EQ(planes.variance_y[i], before.variance_y[i]);
    }
  }
}

/// Information and its right side, from a block's cells.
struct NormalEquations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

/// Cells at random places of a block, and their sums.
NormalEquations add_cells(BlockSums& sums, std::size_t block, std::size_t cells,
                          SignedNumbers& number) {
  NormalEquations equations;
  for (std::size_t i = 0; i < cells; ++i) {
    const float w = 1.0F, x = number(), y = number(), z = 2.0F * number();
    sums.w[block] += w, sums.x[block] += w * x, sums.y[block] += w * y;
    sums.xx[block] += w * x * x, sums.xy[block] += w * x * y, sums.yy[block] += w * y * y;
    sums.z[block] += w * z, sums.xz[block] += w * x * z, sums.yz[block] += w * y * z;
    const Eigen::Vector3d at(1.0, static_cast<double>(x), static_cast<double>(y));
    equations.matrix += at * at.transpose();
    equations.right += at * static_cast<double>(z);
  }
  return equations;
}

TEST_P(PlaneKernels, CorrectRowIsTheMostLikelyPlane) {
  constexpr std::size_t kRow = 2;
  constexpr std::size_t kCount = 37;
  SignedNumbers number;
  BlockSums sums;
  sums.resize(kRow + kCount + 1);
  BlockPlanes planes = some_planes(kRow + kCount + 1);
  const BlockPlanes before = planes;
  std::vector<NormalEquations> equations;
  // From one cell to more than say anything of their own.
  for (std::size_t i = 0; i < kCount; ++i)
    equations.push_back(add_cells(sums, kRow + i, i + 1, number));
  correct_row(sums, kBlockScatter, planes, kRow, kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    SCOPED_TRACE(i);
    const std::size_t at = kRow + i;
    const double cells = static_cast<double>(i + 1);
    const double per_cell = (cells > 12.0 ? 12.0 / cells : 1.0) / 0.0025;
    const Eigen::Vector3d variance =
        Eigen::Vector3f(before.variance_height[at], before.variance_x[at], before.variance_y[at])
            .cast<double>();
    const Eigen::Vector3d expected =
        Eigen::Vector3f(before.height[at], before.slope_x[at], before.slope_y[at]).cast<double>();
    const Eigen::Matrix3d prior = variance.cwiseInverse().asDiagonal();
    const Eigen::Matrix3d covariance = (per_cell * equations[i].matrix + prior).inverse();
    const Eigen::Vector3d plane = covariance * (per_cell * equations[i].right + prior * expected);
    EXPECT_NEAR(static_cast<double>(planes.height[at]), plane[0], 1e-3);
    EXPECT_NEAR(static_cast<double>(planes.slope_x[at]), plane[1], 1e-3);
    EXPECT_NEAR(static_cast<double>(planes.slope_y[at]), plane[2], 1e-3);
    EXPECT_NEAR(static_cast<double>(planes.variance_height[at]) / covariance(0, 0), 1.0, 1e-3);
    EXPECT_NEAR(static_cast<double>(planes.variance_x[at]) / covariance(1, 1), 1.0, 1e-3);
    EXPECT_NEAR(static_cast<double>(planes.variance_y[at]) / covariance(2, 2), 1.0, 1e-3);
  }
  EXPECT_EQ(planes.variance_x[kRow - 1], before.variance_x[kRow - 1]);
  EXPECT_EQ(planes.variance_x[kRow + kCount], before.variance_x[kRow + kCount]);
}

/// Cells of 1 m in blocks of five: the middle of block b is that of cell 5 b + 2.
CellPlaces places_of_blocks(std::int32_t blocks) {
  CellPlaces places;
  const std::int32_t cells = 5 * blocks;
  const auto room = static_cast<std::size_t>(cells) + kRowSpare;
  for (std::vector<float>* numbers : {&places.share_after, &places.from_before, &places.from_after})
    numbers->resize(room);
  places.runs.push_back({0, 2, 0, 0});
  for (std::int32_t b = 0; b + 1 < blocks; ++b)
    places.runs.push_back({5 * b + 2, 5 * b + 7, b, b + 1});
  places.runs.push_back({cells - 3, cells, blocks - 1, blocks - 1});
  for (const CellRun& run : places.runs)
    for (std::int32_t cell = run.begin; cell < run.end; ++cell) {
      const auto i = static_cast<std::size_t>(cell);
      places.from_before[i] = static_cast<float>(cell - (5 * run.before + 2));
      places.from_after[i] = static_cast<float>(cell - (5 * run.after + 2));
      places.share_after[i] = run.before == run.after ? 0.0F : places.from_before[i] / 5.0F;
    }
  return places;
}

TEST_P(PlaneKernels, EvaluateAlongGivesBackAPlane) {
  for (std::int32_t blocks = 1; blocks <= 9; ++blocks) {
    const CellPlaces places = places_of_blocks(blocks);
    BlockPlanes planes = some_planes(static_cast<std::size_t>(blocks) + 1);
    for (std::int32_t b = 0; b < blocks; ++b) {
      const auto at = static_cast<std::size_t>(b) + 1;
      planes.height[at] = 1.0F + 0.25F * static_cast<float>(5 * b + 2);
      planes.slope_x[at] = 0.25F;
      planes.slope_y[at] = -0.125F;
    }
    SurfaceRow surface{std::vector<float>(places.share_after.size()),
                       std::vector<float>(places.share_after.size())};
    evaluate_along(planes, 1, places, surface);
    for (std::size_t cell = 0; cell < static_cast<std::size_t>(5 * blocks); ++cell) {
      EXPECT_FLOAT_EQ(surface.height[cell], 1.0F + 0.25F * static_cast<float>(cell)) << cell;
      EXPECT_EQ(surface.slope_y[cell], -0.125F) << cell;
    }
  }
}

TEST_P(PlaneKernels, EvaluateAlongBlendsThePlanesOnBothSides) {
  const CellPlaces places = places_of_blocks(6);
  const BlockPlanes planes = some_planes(6);
  SurfaceRow surface{std::vector<float>(places.share_after.size()),
                     std::vector<float>(places.share_after.size())};
  evaluate_along(planes, 0, places, surface);
  const auto number = [](float value) { return static_cast<double>(value); };
  for (const CellRun& run : places.runs)
    for (std::int32_t cell = run.begin; cell < run.end; ++cell) {
      const auto before = static_cast<std::size_t>(run.before);
      const auto after = static_cast<std::size_t>(run.after);
      const int from = cell - (5 * run.before + 2);
      const double share = before == after ? 0.0 : from / 5.0;
      const double left = number(planes.height[before]) + from * number(planes.slope_x[before]);
      const double right =
          number(planes.height[after]) + (from - 5) * number(planes.slope_x[after]);
      const auto i = static_cast<std::size_t>(cell);
      EXPECT_NEAR(number(surface.height[i]), (1.0 - share) * left + share * right, 1e-5) << cell;
      EXPECT_NEAR(
          number(surface.slope_y[i]),
          (1.0 - share) * number(planes.slope_y[before]) + share * number(planes.slope_y[after]),
          1e-6)
          << cell;
    }
}

TEST_P(PlaneKernels, EvaluateBetweenIsLinearBetweenTheRows) {
  SignedNumbers number;
  for (std::size_t count = 0; count <= 70; ++count) {
    SurfaceRow lower, upper;
    std::vector<float> expected;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::vector<float>* values :
           {&lower.height, &lower.slope_y, &upper.height, &upper.slope_y})
        values->push_back(number());
      // 0.7 of the line from below and 0.3 of that from above.
      expected.push_back(0.7F * (lower.height[i] + 1.5F * lower.slope_y[i]) +
                         0.3F * (upper.height[i] - 3.5F * upper.slope_y[i]));
    }
    std::vector<float> surface(count, -99.0F);
    evaluate_between({&lower, &upper, 1.5F, -3.5F, 0.3F}, count, surface.data());
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_NEAR(surface[i], expected[i], 2e-6F) << i << " of " << count;
  }
}

INSTANTIATE_TEST_SUITE_P(With, PlaneKernels, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
