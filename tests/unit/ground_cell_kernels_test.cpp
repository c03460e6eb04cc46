#include "core/kernels/ground_cell_kernels.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

constexpr int kWindow = 13;

/// Two thirds of the cells of a window with points; all sums over them are exact in float.
struct WeightedWindow {
  std::vector<WeightedCell> cells = std::vector<WeightedCell>(kWindow * kWindow);
  std::vector<std::uint32_t> occupied{};

  WeightedWindow() {
    std::mt19937 random(1);
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
      if (random() % 3 == 0) continue;
      const auto points = static_cast<float>(1 + random() % 20);
      const float height = (static_cast<float>(random() % 257) - 128.0F) / 64.0F;
      const float variance = static_cast<float>(random() % 16) / 8192.0F;
      cells[i] = {points, points * height, points * variance, variance};
      occupied.push_back(i);
    }
  }
  [[nodiscard]] WeightedCell sum(int column, int row, int half) const {
    WeightedCell patch;
    for (int y = row - half; y <= row + half; ++y)
      for (int x = column - half; x <= column + half; ++x) {
        if (x < 0 || y < 0 || x >= kWindow || y >= kWindow) continue;
        const WeightedCell& cell = cells[static_cast<std::size_t>(y * kWindow + x)];
        patch.points += cell.points;
        patch.min_height += cell.min_height;
        patch.variance += cell.variance;
      }
    return patch;
  }
};

class GroundCellKernels : public testing::OnInstructionSet {};

TEST_P(GroundCellKernels, WeighCellsWritesMomentsOfOccupiedCells) {
  std::vector<CellStatistics> statistics(5);
  // 1, 2 and 6 steps: mean 3, variance (4 + 1 + 9) / 3 steps²
  statistics[1] = {9, 41, 1, 6, 3};
  statistics[4] = {-20'000, 400'000'000, -20'000, -20'000, 1};
  std::vector<WeightedCell> cells(5, {-1.0F, -1.0F, -1.0F, -1.0F});
  weigh_cells(std::vector<std::uint32_t>{1, 4}, statistics.data(), cells.data());
  EXPECT_EQ(cells[1].points, 3.0F);
  EXPECT_FLOAT_EQ(cells[1].min_height, 3e-4F);
  EXPECT_FLOAT_EQ(cells[1].variance, 14e-8F);
  EXPECT_FLOAT_EQ(cells[1].own_variance, 14e-8F / 3.0F);
  EXPECT_EQ(cells[4].points, 1.0F);
  EXPECT_FLOAT_EQ(cells[4].min_height, -2.0F);
  EXPECT_EQ(cells[4].variance, 0.0F);
  EXPECT_EQ(cells[4].own_variance, 0.0F);
  for (const std::size_t empty : {0U, 2U, 3U}) EXPECT_EQ(cells[empty].points, -1.0F) << empty;
}

const std::vector<std::uint8_t> kAllSupported(kWindow* kWindow, 1);
constexpr Point3f kNear{0.0F, 0.0F, 1.7F};
constexpr Point3f kFar{0.0F, 41.0F, 1.7F};  // patches of 5 × 5 cells

/// Cells so small that no slope counts.
ClassRule window_rule(const WeightedWindow& window, const Point3f& sensor = kNear) {
  return {window.cells.data(), kWindow, 0.001F, kAllSupported.data(), {&sensor, 1}};
}

TEST_P(GroundCellKernels, ClassifyCellsSumsPatchesAtTheBorderAndInside) {
  const WeightedWindow window;
  for (const Point3f* sensor : {&kNear, &kFar}) {
    std::vector<GroundCell> answers(window.occupied.size());
    std::vector<std::uint8_t> is_ground(window.cells.size(), 7);
    classify_cells(window.occupied, window_rule(window, *sensor), answers.data(), is_ground.data());
    std::size_t ground = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto cell = window.occupied[i];
      SCOPED_TRACE(cell);
      const WeightedCell patch =
          window.sum(static_cast<int>(cell) % kWindow, static_cast<int>(cell) / kWindow,
                     sensor == &kNear ? 1 : 2);
      const WeightedCell& own = window.cells[cell];
      const float variance = own.points >= 10.0F ? own.own_variance : patch.variance / patch.points;
      EXPECT_EQ(answers[i].patch_points, patch.points);
      EXPECT_EQ(answers[i].patch_elevation, patch.min_height / patch.points);
      EXPECT_EQ(answers[i].variance, variance);
      EXPECT_TRUE(answers[i].observed);
      EXPECT_EQ(answers[i].ground, variance < 1e-3F);
      EXPECT_EQ(is_ground[cell], variance < 1e-3F ? 1 : 0);
      if (answers[i].ground) ++ground;
    }
    EXPECT_GT(ground, 10U);
    EXPECT_LT(ground, answers.size() - 10);
    EXPECT_EQ(std::count(is_ground.begin(), is_ground.end(), 7),
              static_cast<std::ptrdiff_t>(window.cells.size() - window.occupied.size()));
  }
}

TEST_P(GroundCellKernels, ClassifyCellsTakesAnyPartOfTheOccupiedOnes) {
  const WeightedWindow window;
  const ClassRule rule = window_rule(window);
  std::vector<GroundCell> all(window.occupied.size());
  std::vector<std::uint8_t> is_ground(window.cells.size());
  classify_cells(window.occupied, rule, all.data(), is_ground.data());
  std::vector<GroundCell> part(5);
  const std::size_t first = window.occupied.size() - 7;
  classify_cells(std::span(window.occupied).subspan(first, 5), rule, part.data(), is_ground.data());
  for (std::size_t i = 0; i < part.size(); ++i) {
    EXPECT_EQ(part[i].patch_points, all[first + i].patch_points);
    EXPECT_EQ(part[i].variance, all[first + i].variance);
    EXPECT_EQ(part[i].ground, all[first + i].ground);
  }
}

TEST_P(GroundCellKernels, SlopesAreTakenOutUpToTheSteepest) {
  WeightedWindow window;
  window.cells.assign(window.cells.size(), {});
  const std::vector<std::uint32_t> occupied{0, 1, 2};
  // Cells of one metre along x, whose points spread evenly; the one at the border has no slope.
  const auto classes = [&](float rise) {
    const float variance = rise * rise / 12.0F;
    for (const std::uint32_t cell : occupied)
      window.cells[cell] = {20.0F, 20.0F * rise * static_cast<float>(cell), 20.0F * variance,
                            variance};
    ClassRule rule = window_rule(window);
    rule.cell_size = 1.0F;
    std::vector<GroundCell> answers(3);
    std::vector<std::uint8_t> is_ground(window.cells.size());
    classify_cells(occupied, rule, answers.data(), is_ground.data());
    return std::vector<std::uint8_t>(is_ground.begin(), is_ground.begin() + 3);
  };
  EXPECT_EQ(classes(0.5F), (std::vector<std::uint8_t>{0, 1, 0}));
  // 0.7083² / 12 = 0.001 + 0.7² / 12
  EXPECT_EQ(classes(0.708F), (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(classes(0.709F), (std::vector<std::uint8_t>{0, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(With, GroundCellKernels, testing::all_instruction_sets(),
                         testing::name_of);

}  // namespace
}  // namespace groundgrid
