#include "io/calibration.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

constexpr const char* kMounting = "0 -1 0 0.5 0 0 -1 -0.08 1 0 0 -0.27";

Eigen::Isometry3d read_calibration_text(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "calib.txt", text);
  return read_lidar_calibration(folder / "calib.txt");
}

class CalibrationForm : public ::testing::TestWithParam<const char*> {};

TEST_P(CalibrationForm, IsRead) {
  const Eigen::Isometry3d T_camera_lidar = read_calibration_text(
      std::string("P0: 1 2 3\nTr_imu_velo 9 9 9\n") + GetParam() + kMounting + "  \r\nx: 1\n");
  // One metre ahead of the LiDAR, z of the camera; by hand: (0.5, -0.08, 1 - 0.27).
  const Eigen::Vector3d in_camera = T_camera_lidar * Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_TRUE(in_camera.isApprox(Eigen::Vector3d(0.5, -0.08, 0.73), 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Kitti, CalibrationForm,
                         ::testing::Values("Tr: ", "Tr ", "Tr_velo_cam ", "Tr_velo_to_cam: "));

TEST(Calibration, MayBeginWithAByteOrderMark) {
  const Eigen::Isometry3d T_camera_lidar =
      read_calibration_text(std::string("\xEF\xBB\xBFTr: +") + kMounting);
  EXPECT_EQ(T_camera_lidar.translation(), Eigen::Vector3d(0.5, -0.08, -0.27));
}

TEST(Calibration, MustHaveTheMounting) {
  const std::string message =
      message_of<Error>([] { read_calibration_text("P0: 1 2 3\nTr_imu_velo 1 2 3\n"); });
  EXPECT_TRUE(contains(message, "calib.txt: expected a line 'Tr:'"));
  EXPECT_TRUE(contains(message, "--single-scan"));
}

TEST(Calibration, MustBeRigid) {
  EXPECT_TRUE(contains(
      message_of<Error>([] { read_calibration_text("P0: 1\nTr: 2 0 0 0 0 2 0 0 0 0 2 0\n"); }),
      "calib.txt, line 2: expected the twelve numbers of a rigid transform"));
}

TEST(Calibration, MustBeTwelveNumbers) {
  EXPECT_TRUE(
      contains(message_of<Error>([] { read_calibration_text("Tr: 1 0 0\n"); }), "got 3 numbers"));
  EXPECT_TRUE(
      contains(message_of<Error>([] { read_calibration_text("Tr: 1 0 0 0 0 one 0 0 0 0 1 0\n"); }),
               "got something that is no number"));
}

}  // namespace
}  // namespace groundgrid::io
