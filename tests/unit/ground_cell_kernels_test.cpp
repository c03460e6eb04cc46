#include "core/ground_cell_kernels.hpp"

#include <algorithm>
#include <cmath>
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
      const float variance = static_cast<float>(random() % 64) / 4096.0F;
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

/// Sensor over the middle cell; 5 × 5 patches from 4 m on, own variance from 12 points on.
ClassRule window_rule(const WeightedWindow& window, const std::vector<Point3f>& sensors) {
  ClassRule rule;
  rule.cells = window.cells.data();
  rule.size = kWindow;
  rule.cell_size = 1.0F;
  rule.sensors = sensors;
  rule.patch_change_squared = 16.0F;
  rule.own_variance_points = 12.0F;
  rule.variance_per_metre = 0.001F;
  rule.least_threshold = 0.003F;
  return rule;
}

TEST_P(GroundCellKernels, ClassifyCellsSumsPatchesAtTheBorderAndInside) {
  const WeightedWindow window;
  // Each cell near one of them and far from it in turn: both patches at borders and inside.
  for (const Point3f sensor :
       {Point3f{6.5F, 6.5F, 1.7F}, Point3f{0.5F, 0.5F, 1.7F}, Point3f{12.5F, 12.5F, 1.7F}}) {
    const std::vector<Point3f> sensors{sensor};
    const ClassRule rule = window_rule(window, sensors);
    std::vector<GroundCell> answers(window.occupied.size());
    std::vector<std::uint8_t> is_ground(window.cells.size(), 7);
    classify_cells(window.occupied, rule, answers.data(), is_ground.data());
    std::size_t ground = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto cell = window.occupied[i];
      SCOPED_TRACE(cell);
      const int column = static_cast<int>(cell) % kWindow;
      const int row = static_cast<int>(cell) / kWindow;
      const float x = static_cast<float>(column) + 0.5F - sensor.x;
      const float y = static_cast<float>(row) + 0.5F - sensor.y;
      const float distance_squared = x * x + y * y;
      const WeightedCell patch = window.sum(column, row, distance_squared < 16.0F ? 1 : 2);
      const WeightedCell& own = window.cells[cell];
      const float variance = own.points >= 12.0F ? own.own_variance : patch.variance / patch.points;
      const float threshold = std::max(0.001F * std::sqrt(distance_squared), 0.003F);
      EXPECT_EQ(answers[i].patch_points, patch.points);
      EXPECT_FLOAT_EQ(answers[i].patch_elevation, patch.min_height / patch.points);
      EXPECT_FLOAT_EQ(answers[i].variance, variance);
      EXPECT_TRUE(answers[i].observed);
      EXPECT_EQ(answers[i].ground, variance < threshold);
      EXPECT_EQ(is_ground[cell], variance < threshold ? 1 : 0);
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
  const std::vector<Point3f> sensors{{6.5F, 6.5F, 1.7F}, {1.5F, 1.5F, 1.7F}};
  const ClassRule rule = window_rule(window, sensors);
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

TEST_P(GroundCellKernels, EnoughPointsFromTheirDistanceOn) {
  // Two points are enough from 2 m on, one is from 3 m on, three always are.
  const std::vector<float> enough_from{100.0F, 9.0F, 4.0F};
  const std::vector<Point3f> sensors{{0.5F, 0.5F, 1.7F}};
  WeightedWindow window;
  window.cells.assign(window.cells.size(), {});
  const std::vector<std::uint32_t> occupied{0, 1, 2, 3, 4};
  const auto observed = [&](float points) {
    for (const std::uint32_t cell : occupied) window.cells[cell] = {points, 0.0F, 0.0F, 0.0F};
    ClassRule rule = window_rule(window, sensors);
    rule.enough_from = enough_from;
    std::vector<GroundCell> answers(occupied.size());
    std::vector<std::uint8_t> is_ground(window.cells.size());
    classify_cells(occupied, rule, answers.data(), is_ground.data());
    std::vector<bool> seen;
    for (const GroundCell& answer : answers) {
      EXPECT_EQ(answer.ground, answer.observed);
      seen.push_back(answer.observed);
    }
    return seen;
  };
  EXPECT_EQ(observed(1.0F), (std::vector<bool>{false, false, false, true, true}));
  EXPECT_EQ(observed(2.0F), (std::vector<bool>{false, false, true, true, true}));
  EXPECT_EQ(observed(3.0F), (std::vector<bool>{true, true, true, true, true}));
}

TEST_P(GroundCellKernels, SlopesAreTakenOutUpToTheSteepest) {
  // Up by 0.5 m a cell along x: a variance of 0.5² / 12 = 0.0208 within each, over the threshold of
  // 0.003. The cell at the border has no slope along x.
  const std::vector<Point3f> sensors{{6.5F, 6.5F, 1.7F}};
  WeightedWindow window;
  window.cells.assign(window.cells.size(), {});
  const std::vector<std::uint32_t> occupied{0, 1, 2};
  for (const std::uint32_t cell : occupied)
    window.cells[cell] = {20.0F, 10.0F * static_cast<float>(cell), 20.0F * 0.0208F, 0.0208F};
  const auto classes = [&](float steepest_squared) {
    ClassRule rule = window_rule(window, sensors);
    rule.variance_per_metre = 0.0F;
    rule.steepest_squared = steepest_squared;
    std::vector<GroundCell> answers(3);
    std::vector<std::uint8_t> is_ground(window.cells.size());
    classify_cells(occupied, rule, answers.data(), is_ground.data());
    return std::vector<std::uint8_t>(is_ground.begin(), is_ground.begin() + 3);
  };
  EXPECT_EQ(classes(1.0F), (std::vector<std::uint8_t>{0, 1, 0}));
  // 0.003 + 0.25 / 12 = 0.0238 suffices, 0.003 + 0.2 / 12 = 0.0197 does not.
  EXPECT_EQ(classes(0.25F), (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(classes(0.2F), (std::vector<std::uint8_t>{0, 0, 0}));
}

INSTANTIATE_TEST_SUITE_P(With, GroundCellKernels, testing::all_instruction_sets(),
                         testing::name_of);

}  // namespace
}  // namespace groundgrid
