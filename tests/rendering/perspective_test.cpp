#include "rendering/perspective.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "image_checks.hpp"
#include "rendering/view_point.hpp"

namespace groundgrid::rendering {
namespace {

using test::count_of;

constexpr ImageSize kSceneSize{200, 100};

// Looks ahead along x from 10 m behind the origin; the picture is 10 m high there.
Camera level_camera() {
  return {.eye = {-10.0, 0.0, 0.0},
          .target = {0.0, 0.0, 0.0},
          .vertical_field_deg = 2.0 * std::atan(0.5) * 180.0 / 3.14159265358979};
}

Vertex point(float x, float y, float z, Color color) {
  return {.x = x, .y = y, .z = z, .size_m = 1.0F, .color = color};
}

TEST(Perspective, ShowsAPointWhereItLies) {
  const PerspectiveRenderer renderer;
  // 10 pixels a metre at the origin, half of that 10 m behind it.
  const Scene scene{.points = {point(0.0F, 5.0F, 3.0F, kBlue), point(10.0F, -10.0F, 0.0F, kOrange)},
                    .depth_shading = 0.0};
  const Image image = renderer.draw(scene, level_camera(), kSceneSize);
  EXPECT_EQ(image.size, kSceneSize);
  EXPECT_EQ(image.at(50, 20), kBlue) << "left and up";
  EXPECT_EQ(image.at(150, 50), kOrange) << "right and farther away";
  EXPECT_EQ(image.at(100, 50), kWhite);
  EXPECT_NEAR(static_cast<double>(count_of(image, kBlue)), 78.5, 20.0) << "a disc of 1 m";
  EXPECT_NEAR(static_cast<double>(count_of(image, kOrange)), 19.6, 10.0) << "half as wide";
}

TEST(Perspective, PointsAreNeverSmallerThanAskedFor) {
  const PerspectiveRenderer renderer;
  Vertex speck = point(0.0F, 0.0F, 0.0F, kBlack);
  speck.size_m = 0.001F;
  const Image image = renderer.draw(
      {.points = {speck}, .least_point_px = 6.0, .depth_shading = 0.0}, level_camera(), kSceneSize);
  EXPECT_GT(count_of(image, kBlack), 12U);
}

TEST(Perspective, WhatIsNearerHidesWhatIsBehind) {
  const PerspectiveRenderer renderer;
  const Vertex near = point(-1.0F, 0.0F, 0.0F, kBlue);
  const Vertex far = point(1.0F, 0.0F, 0.0F, kOrange);
  for (const auto& points : {std::vector{near, far}, std::vector{far, near}}) {
    const Image image =
        renderer.draw({.points = points, .depth_shading = 0.0}, level_camera(), kSceneSize);
    EXPECT_EQ(image.at(100, 50), kBlue);
    EXPECT_EQ(count_of(image, kOrange), 0U);
  }
}

TEST(Perspective, TrianglesAreFilled) {
  const PerspectiveRenderer renderer;
  const Image image =
      renderer.draw({.corners = {point(0.0F, 2.0F, -2.0F, kBlue), point(0.0F, -2.0F, -2.0F, kBlue),
                                 point(0.0F, -2.0F, 2.0F, kBlue)},
                     .triangles = {0, 1, 2},
                     .depth_shading = 0.0},
                    level_camera(), kSceneSize);
  EXPECT_NEAR(static_cast<double>(count_of(image, kBlue)), 800.0, 60.0);
  EXPECT_EQ(image.at(110, 60), kBlue);
  EXPECT_EQ(image.at(90, 40), kWhite);
}

TEST(Perspective, DepthShadingDarkensWhatLiesBehindAnEdgeOnly) {
  const PerspectiveRenderer renderer;
  Vertex wall = point(5.0F, 0.0F, 0.0F, kYellow);
  wall.size_m = 12.0F;
  const Image image =
      renderer.draw({.points = {wall, point(-3.0F, 0.0F, 0.0F, kBlue)}, .depth_shading = 1.0},
                    level_camera(), kSceneSize);
  EXPECT_EQ(image.at(100, 50), kBlue);
  EXPECT_EQ(image.at(100, 20), kYellow) << "far from the edge";
  // The blue disc has a radius of 5 / 0.7 pixels.
  EXPECT_LT(image.at(100, 50 - 8).red, 200) << "beside the edge";
}

TEST(Perspective, IsTheSameTwice) {
  const Scene scene{.points = {point(0.0F, 1.0F, 1.0F, kBlue), point(4.0F, -2.0F, 0.3F, kOrange)}};
  EXPECT_EQ(PerspectiveRenderer().draw(scene, level_camera(), kSceneSize).pixels,
            PerspectiveRenderer().draw(scene, level_camera(), kSceneSize).pixels);
}

TEST(ViewPoint, LooksWhereItIsSaid) {
  const Camera ahead = camera_at({.azimuth_deg = 0.0, .elevation_deg = 0.0, .distance_m = 10.0},
                                 {1.0, 2.0, 3.0}, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(ahead.eye.isApprox(Eigen::Vector3d(-9.0, 2.0, 3.0)));
  const Camera left = camera_at({.azimuth_deg = 90.0, .elevation_deg = 30.0, .distance_m = 10.0},
                                {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(left.eye.isApprox(Eigen::Vector3d(0.0, -10.0 * std::sqrt(0.75), 5.0)));
}

TEST(ViewPoint, FillsThePictureWithAllPlaces) {
  const std::vector<Eigen::Vector3d> places{
      {-50.0, -10.0, 0.0}, {50.0, -10.0, 2.0}, {50.0, 10.0, 0.0}, {-50.0, 10.0, 8.0}};
  const Rectangle plot{0.0, 0.0, 200.0, 100.0};
  const Camera camera = camera_around({.azimuth_deg = 20.0, .elevation_deg = 30.0}, places,
                                      Eigen::Vector3d::UnitY(), 2.0);
  double widest = 0.0;
  for (const Eigen::Vector3d& place : places) {
    const PixelPoint seen = place_on(plot, camera, place);
    EXPECT_GT(seen.x, 0.0);
    EXPECT_LT(seen.x, 200.0);
    EXPECT_GT(seen.y, 0.0);
    EXPECT_LT(seen.y, 100.0);
    widest = std::max({widest, std::abs(seen.x - 100.0) / 100.0, std::abs(seen.y - 50.0) / 50.0});
  }
  EXPECT_GT(widest, 0.9);
}

TEST(ViewPoint, APlaceBehindTheEyeIsNotOnThePlot) {
  EXPECT_LT(place_on({0.0, 0.0, 200.0, 100.0}, level_camera(), {-20.0, 0.0, 0.0}).x, 0.0);
}

}  // namespace
}  // namespace groundgrid::rendering
