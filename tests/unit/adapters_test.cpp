// Views of other libraries' clouds show the same points, where they lie.
#include <gtest/gtest.h>

#include <vector>

#include "core/point_transform.hpp"
#include "groundgrid/adapters/eigen.hpp"
#include "groundgrid/adapters/pcl.hpp"
#include "groundgrid/adapters/span.hpp"

namespace groundgrid {
namespace {

void expect_points(const PointView& view, const void* memory) {
  ASSERT_EQ(view.count, 2U);
  EXPECT_EQ(static_cast<const void*>(view.data), memory);
  const Point3f first = load_point(view, 0);
  const Point3f second = load_point(view, 1);
  EXPECT_EQ(first.x, 1.0F);
  EXPECT_EQ(first.y, 2.0F);
  EXPECT_EQ(first.z, 3.0F);
  EXPECT_EQ(second.x, 4.0F);
  EXPECT_EQ(second.y, 5.0F);
  EXPECT_EQ(second.z, 6.0F);
}

TEST(Adapters, EigenMatrixWithOnePointAColumn) {
  Eigen::Matrix3Xf points(3, 2);
  points << 1, 4, 2, 5, 3, 6;
  expect_points(view_of(points), points.data());
  Eigen::Matrix4Xf homogeneous(4, 2);
  homogeneous << 1, 4, 2, 5, 3, 6, 1, 1;
  expect_points(view_of(homogeneous), homogeneous.data());
}

TEST(Adapters, EigenMatrixWithOnePointARow) {
  Eigen::Matrix<float, Eigen::Dynamic, 5, Eigen::RowMajor> points(2, 5);
  points << 1, 2, 3, 0, 0, 4, 5, 6, 0, 0;
  expect_points(view_of(points), points.data());
}

struct OwnPoint {
  double time;
  float intensity;
  float z, y, x;
};

TEST(Adapters, SpanOfOwnPoints) {
  const std::vector<OwnPoint> points{{0.0, 0.0F, 3.0F, 2.0F, 1.0F}, {0.0, 0.0F, 6.0F, 5.0F, 4.0F}};
  expect_points(view_of(std::span<const OwnPoint>(points)), points.data());
  expect_points(view_of(points), points.data());
  std::vector<OwnPoint> mutable_points = points;
  expect_points(view_of(std::span<OwnPoint, 2>(mutable_points)), mutable_points.data());
}

/// Shaped like pcl::PointCloud<pcl::PointXYZ>.
struct CloudLikePcl {
  struct PointType {
    float x, y, z, padding;
  };
  std::vector<PointType> points;
};

TEST(Adapters, PclCloud) {
  const CloudLikePcl cloud{{{1.0F, 2.0F, 3.0F, 0.0F}, {4.0F, 5.0F, 6.0F, 0.0F}}};
  expect_points(view_of(cloud), cloud.points.data());
}

}  // namespace
}  // namespace groundgrid
