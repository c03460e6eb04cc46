// How many points of one scan fell around each cell.
#include "geotiff/point_density.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "small_map.hpp"

namespace groundgrid::geotiff {
namespace {

using test::SmallMap;

std::vector<std::uint32_t> points_around(const SmallMap& map) {
  std::vector<std::uint32_t> points;
  count_points_around(map.view(), points);
  return points;
}

TEST(PointDensity, ItsSquareIsTheOneNearestToAMetre) {
  EXPECT_EQ(density_reach(2.0), 0);
  EXPECT_EQ(density_reach(1.0), 0);
  EXPECT_EQ(density_reach(0.5), 1);
  EXPECT_EQ(density_reach(0.33), 1);
  EXPECT_EQ(density_reach(0.2), 2);
  EXPECT_EQ(density_reach(0.1), 5);
  EXPECT_DOUBLE_EQ(density_area_m2(0.33), 0.9801);
  EXPECT_DOUBLE_EQ(density_area_m2(0.2), 1.0);
  EXPECT_DOUBLE_EQ(density_area_m2(2.0), 4.0);
}

TEST(PointDensity, CountsTheCellAndItsNeighbours) {
  SmallMap map(4, 0.33);
  map.set(0, 0, 0.0F, 0.0F, 1);
  map.set(2, 1, 0.0F, 0.0F, 10);
  EXPECT_EQ(points_around(map), (std::vector<std::uint32_t>{1, 11, 10, 10,  //
                                                            1, 11, 10, 10,  //
                                                            0, 10, 10, 10,  //
                                                            0, 0, 0, 0}));
}

TEST(PointDensity, ReachesFartherWhereCellsAreSmaller) {
  SmallMap map(7, 0.2);
  map.set(3, 3, 0.0F, 0.0F, 5);
  const std::vector<std::uint32_t> points = points_around(map);
  EXPECT_EQ(points[1 * 7 + 1], 5U);
  EXPECT_EQ(points[5 * 7 + 5], 5U);
  EXPECT_EQ(points[0 * 7 + 3], 0U);
  EXPECT_EQ(points[3 * 7 + 6], 0U);
}

TEST(PointDensity, ForgetsTheScanBefore) {
  SmallMap map(2, 0.33);
  map.set(0, 0, 0.0F, 0.0F, 3);
  std::vector<std::uint32_t> points{9, 9, 9, 9, 9, 9};
  count_points_around(map.view(), points);
  EXPECT_EQ(points, (std::vector<std::uint32_t>{3, 3, 3, 3}));
}

TEST(PointDensity, StaysAtItsGreatestValue) {
  SmallMap map(2, 0.33);
  map.set(0, 0, 0.0F, 0.0F, 3'000'000'000U);
  map.set(1, 0, 0.0F, 0.0F, 3'000'000'000U);
  EXPECT_EQ(points_around(map)[0], std::numeric_limits<std::uint32_t>::max());
}

}  // namespace
}  // namespace groundgrid::geotiff
