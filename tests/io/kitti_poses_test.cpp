#include "io/kitti_poses.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "io/error.hpp"
#include "oversized_file.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

// The camera looks along the LiDAR's x, 0.27 m before it and 0.08 m below it.
constexpr const char* kCalibration = "Tr: 0 -1 0 0 0 0 -1 -0.08 1 0 0 -0.27\n";
constexpr const char* kStart = "1 0 0 0 0 1 0 0 0 0 1 0\n";
constexpr const char* kTwoMetresAhead = "1 0 0 0 0 1 0 0 0 0 1 2\n";
constexpr const char* kTurnedLeft = "0 0 -1 0 0 1 0 0 1 0 0 0\n";

KittiPoses read(const std::string& poses, const std::string& calibration = kCalibration) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "poses.txt", poses);
  test::write_file(folder / "calib.txt", calibration);
  return {folder / "poses.txt", folder / "calib.txt"};
}

TEST(KittiPoses, AreTheLidarsNotTheCameras) {
  const KittiPoses poses = read(std::string(kStart) + kTwoMetresAhead + kTurnedLeft + "\n \n");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_TRUE(poses.pose(0).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  // The camera's z is the LiDAR's x.
  EXPECT_TRUE(
      poses.pose(1).isApprox(Eigen::Isometry3d(Eigen::Translation3d(2.0, 0.0, 0.0)), 1e-12));
  // The camera turns left by 90° where it stands, at (0.27, 0, -0.08) of the LiDAR's first frame;
  // the LiDAR, 0.27 m behind it, swings to its right: (0.27, 0) - (0, 0.27).
  const Eigen::Isometry3d turned =
      Eigen::Translation3d(0.27, -0.27, 0.0) *
      Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(poses.pose(2).isApprox(turned, 1e-12));
}

TEST(KittiPoses, BelongToScansByNumber) {
  const KittiPoses poses = read(std::string(kStart) + kStart + kTwoMetresAhead);
  EXPECT_NEAR(poses.pose(2).translation().x(), 2.0, 1e-12);
}

TEST(KittiPoses, AreMissedOnlyWhereAScanNeedsThem) {
  const KittiPoses poses = read(std::string(kStart) + kStart);
  EXPECT_NO_THROW((void)poses.pose(1));
  const std::string message = message_of<Error>([&] { (void)poses.pose(2); });
  EXPECT_TRUE(contains(message, "poses.txt, line 3: expected the pose of scan number 2"));
  EXPECT_TRUE(contains(message, "after 2 lines"));
  EXPECT_TRUE(contains(message, "--single-scan"));
}

TEST(KittiPoses, MustBeRigid) {
  const std::string message =
      message_of<Error>([] { read(std::string(kStart) + "1 0 0 0 0 1 0 0 0 0 1.1 0\n"); });
  EXPECT_TRUE(contains(message, "poses.txt, line 2"));
  EXPECT_TRUE(contains(message, "no rotation and translation"));
}

// All that is let through is made exact, so that no stricter check finds fault with it later.
TEST(KittiPoses, AreExactlyRigidOnceRead) {
  const KittiPoses poses = read(
      "1.0004 0 0 0 0 1.0004 0 0 0 0 1.0004 5\n0.9996 0 0 0 0 0.9996 0 0 0 0 0.9996 5\n"
      "0.6 -0.8 4.5e-4 1 0.8 0.6 4.5e-4 2 -4.5e-4 -4.5e-4 1 3\n",
      "Tr: 0 -1.0004 0 0 0 0 -1.0004 -0.08 1.0004 0 0 -0.27\n");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Matrix3d rotation = poses.pose(i).linear();
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << i;
  }
  EXPECT_TRUE(contains(message_of<Error>([] { read("1.0006 0 0 0 0 1.0006 0 0 0 0 1.0006 5\n"); }),
                       "poses.txt, line 1"));
}

TEST(KittiPoses, MustBeTwelveNumbers) {
  EXPECT_TRUE(contains(message_of<Error>([] { read("1 0 0 0 0 1 0 0 0 0 1\n"); }),
                       "line 1: expected the twelve numbers of a rigid transform, got 11 numbers"));
  EXPECT_TRUE(contains(message_of<Error>([] { read(std::string(kStart) + "\n" + kStart); }),
                       "line 2: expected the twelve numbers of a rigid transform, got 0 numbers"));
}

TEST(KittiPoses, NeedTheMounting) {
  EXPECT_TRUE(contains(message_of<Error>([] { read(kStart, "P0: 1 2 3\n"); }), "calib.txt"));
}

TEST(KittiPoses, AreNoDirectory) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<Error>([&] { KittiPoses(folder.path(), folder / "calib.txt"); }),
                       "expected a file, got a directory"));
}

using OversizedPoses = test::OversizedFile;

TEST_F(OversizedPoses, AreNamed) {
  test::make_sparse_file(folder / "poses.txt", kBytes);
  EXPECT_TRUE(
      contains(message_of<Error>([&] { KittiPoses(folder / "poses.txt", folder / "calib.txt"); }),
               "poses.txt: expected a file that fits into memory"));
}

}  // namespace
}  // namespace groundgrid::io
