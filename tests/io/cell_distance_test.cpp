#include "evaluation/cell_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "evaluation/path_distance.hpp"

namespace groundgrid::evaluation {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(CellDistance, IsThatOfTheNearestTarget) {
  const CellLattice lattice{4, 3, 2.0, 1.0};
  const std::vector<std::uint8_t> targets{0, 0, 0, 0,  //
                                          1, 0, 0, 0,  //
                                          0, 0, 0, 7};
  const std::vector<float> distance = distance_to(targets, lattice);
  EXPECT_EQ(distance[lattice.index(0, 1)], 0.0F);
  EXPECT_EQ(distance[lattice.index(3, 2)], 0.0F);
  EXPECT_FLOAT_EQ(distance[lattice.index(0, 0)], 1.0F);
  EXPECT_FLOAT_EQ(distance[lattice.index(3, 0)], 2.0F);
  EXPECT_FLOAT_EQ(distance[lattice.index(1, 0)], std::sqrt(5.0F));
  EXPECT_FLOAT_EQ(distance[lattice.index(2, 0)], std::sqrt(8.0F));
}

TEST(CellDistance, EqualsTheSearchOverAllTargets) {
  std::mt19937 random(5);
  for (const unsigned one_in : {2U, 10U, 60U}) {
    const CellLattice lattice{23, 17, 0.5, 0.7};
    std::vector<std::uint8_t> targets(lattice.cells());
    for (std::uint8_t& target : targets) target = random() % one_in == 0 ? 1 : 0;
    targets[3] = 1;
    const std::vector<float> distance = distance_to(targets, lattice);
    for (int row = 0; row < lattice.rows; ++row) {
      for (int column = 0; column < lattice.columns; ++column) {
        double nearest = 1e9;
        for (int y = 0; y < lattice.rows; ++y)
          for (int x = 0; x < lattice.columns; ++x)
            if (targets[lattice.index(x, y)] != 0)
              nearest = std::min(nearest, std::hypot(0.5 * (x - column), 0.7 * (y - row)));
        ASSERT_NEAR(distance[lattice.index(column, row)], nearest, 1e-5) << column << ", " << row;
      }
    }
  }
}

TEST(CellDistance, IsInfiniteWithoutATarget) {
  EXPECT_EQ(distance_to(std::vector<std::uint8_t>(2), {2, 1, 1.0, 1.0}),
            (std::vector<float>{kInfinity, kInfinity}));
}

TEST(CellDistance, NeedsOneTargetACell) {
  EXPECT_THROW((void)distance_to(std::vector<std::uint8_t>(3), {2, 2, 1.0, 1.0}),
               std::invalid_argument);
}

TEST(PathDistance, IsThatOfTheNearestCellOnThePath) {
  // From the first to the last column of row 1.
  const std::vector<LatticePoint> path{{0.5, 1.5}, {4.2, 1.2}};
  const CellLattice lattice{5, 4, 0.5, 0.5};
  const std::vector<float> distance = path_distance(path, lattice);
  for (int column = 0; column < 5; ++column) {
    EXPECT_FLOAT_EQ(distance[lattice.index(column, 0)], 0.5F) << column;
    EXPECT_EQ(distance[lattice.index(column, 1)], 0.0F) << column;
    EXPECT_FLOAT_EQ(distance[lattice.index(column, 3)], 1.0F) << column;
  }
}

TEST(PathDistance, FollowsAPathThatLeavesAndComesBack) {
  const std::vector<LatticePoint> path{
      {-1e6, 0.5}, {1e300, 0.5}, {0.5, 2.5}, {std::numeric_limits<double>::quiet_NaN(), 3.0}};
  const CellLattice lattice{3, 3, 1.0, 1.0};
  EXPECT_EQ(path_distance(path, lattice)[lattice.index(0, 2)], 0.0F);
}

TEST(PathDistance, IsEmptyWhereThePathIsElsewhere) {
  const std::vector<LatticePoint> path{{-5.0, 0.5}, {-5.0, 9.0}, {3.0, 3.0}};
  EXPECT_TRUE(path_distance(path, {3, 3, 1.0, 1.0}).empty());
  EXPECT_TRUE(path_distance({}, {3, 3, 1.0, 1.0}).empty());
}

}  // namespace
}  // namespace groundgrid::evaluation
