#include "io/scan_poses.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "io/error.hpp"
#include "oversized_file.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;
using test::write_file;

// The camera looks along the LiDAR's x, 0.27 m before it and 0.08 m below it.
constexpr const char* kCalibration = "Tr: 0 -1 0 0 0 0 -1 -0.08 1 0 0 -0.27\n";
constexpr const char* kStart = "1 0 0 0 0 1 0 0 0 0 1 0\n";
constexpr const char* kTwoMetresAhead = "1 0 0 0 0 1 0 0 0 0 1 2\n";
constexpr const char* kTurnedLeft = "0 0 -1 0 0 1 0 0 1 0 0 0\n";

ScanPoses read_kitti(const std::string& poses, const std::string& calibration = kCalibration) {
  const test::TemporaryFolder folder;
  write_file(folder / "poses.txt", poses);
  write_file(folder / "calib.txt", calibration);
  return ScanPoses::kitti(folder / "poses.txt", folder / "calib.txt");
}

ScanFile scan(std::size_t number, std::size_t index = 0) {
  return {std::to_string(number), number, std::to_string(number) + ".bin", ScanFormat::kitti,
          index};
}

Eigen::Isometry3d turned_left(double x, double y, double degrees) {
  return Eigen::Translation3d(x, y, 0.0) *
         Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ());
}

TEST(KittiScanPoses, AreTheLidarsNotTheCameras) {
  const ScanPoses poses = read_kitti(std::string(kStart) + kTwoMetresAhead + kTurnedLeft + "\n \n");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_TRUE(poses.pose(scan(0)).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  // The camera's z is the LiDAR's x.
  EXPECT_TRUE(poses.pose(scan(1)).isApprox(turned_left(2.0, 0.0, 0.0), 1e-12));
  // The camera turns left by 90° where it stands, at (0.27, 0, -0.08) of the LiDAR's first frame;
  // the LiDAR, 0.27 m behind it, swings to its right: (0.27, 0) - (0, 0.27).
  EXPECT_TRUE(poses.pose(scan(2)).isApprox(turned_left(0.27, -0.27, 90.0), 1e-12));
}

TEST(KittiScanPoses, BelongToScansByNumber) {
  const ScanPoses poses = read_kitti(std::string(kStart) + kStart + kTwoMetresAhead);
  EXPECT_NEAR(poses.pose(scan(2, 0)).translation().x(), 2.0, 1e-12);
}

TEST(KittiScanPoses, AreMissedOnlyWhereAScanNeedsThem) {
  const ScanPoses poses = read_kitti(std::string(kStart) + kStart);
  EXPECT_NO_THROW((void)poses.pose(scan(1)));
  const std::string message = message_of<Error>([&] { (void)poses.pose(scan(2)); });
  EXPECT_TRUE(contains(message, "poses.txt, line 3: expected the pose of scan number 2"));
  EXPECT_TRUE(contains(message, "after 2 lines"));
  EXPECT_TRUE(contains(message, "--single-scan"));
}

TEST(KittiScanPoses, MustBeRigid) {
  const std::string message =
      message_of<Error>([] { read_kitti(std::string(kStart) + "1 0 0 0 0 1 0 0 0 0 1.1 0\n"); });
  EXPECT_TRUE(contains(message, "poses.txt, line 2"));
  EXPECT_TRUE(contains(message, "no rotation and translation"));
}

// All that is let through is made exact, so that no stricter check finds fault with it later.
TEST(KittiScanPoses, AreExactlyRigidOnceRead) {
  const ScanPoses poses = read_kitti(
      "1.0004 0 0 0 0 1.0004 0 0 0 0 1.0004 5\n0.9996 0 0 0 0 0.9996 0 0 0 0 0.9996 5\n"
      "0.6 -0.8 4.5e-4 1 0.8 0.6 4.5e-4 2 -4.5e-4 -4.5e-4 1 3\n",
      "Tr: 0 -1.0004 0 0 0 0 -1.0004 -0.08 1.0004 0 0 -0.27\n");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Matrix3d rotation = poses.pose(scan(i)).linear();
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12) << i;
  }
  EXPECT_TRUE(
      contains(message_of<Error>([] { read_kitti("1.0006 0 0 0 0 1.0006 0 0 0 0 1.0006 5\n"); }),
               "poses.txt, line 1"));
}

TEST(KittiScanPoses, MustBeTwelveNumbers) {
  EXPECT_TRUE(contains(message_of<Error>([] { read_kitti("1 0 0 0 0 1 0 0 0 0 1\n"); }),
                       "line 1: expected the twelve numbers of a rigid transform, got 11 numbers"));
  EXPECT_TRUE(contains(message_of<Error>([] { read_kitti(std::string(kStart) + "\n" + kStart); }),
                       "line 2: expected the twelve numbers of a rigid transform, got 0 numbers"));
}

TEST(KittiScanPoses, NeedTheMounting) {
  EXPECT_TRUE(contains(message_of<Error>([] { read_kitti(kStart, "P0: 1 2 3\n"); }), "calib.txt"));
}

TEST(KittiScanPoses, AreNoDirectory) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(
      contains(message_of<Error>([&] { ScanPoses::kitti(folder.path(), folder / "calib.txt"); }),
               "expected a file, got a directory"));
}

/// A plain sequence and files of poses and times beside it.
class PoseFile : public ::testing::Test {
 protected:
  // Scans with these numbers as names.
  explicit PoseFile(const std::vector<std::size_t>& numbers = {3, 4}) {
    for (const std::size_t number : numbers)
      sequence.scans.push_back(scan(number, sequence.scans.size()));
    sequence.folder = folder.path();
  }

  ScanPoses read(const std::string& text) {
    write_file(folder / "drive.txt", text);
    return ScanPoses::from_file(folder / "drive.txt", sequence);
  }
  std::string error(const std::string& text) {
    return message_of<Error>([&] { read(text); });
  }
  Eigen::Isometry3d pose(const ScanPoses& poses, std::size_t i) const {
    return poses.pose(sequence.scans[i]);
  }

  test::TemporaryFolder folder;
  ScanSequence sequence;
};

constexpr const char* kLidarAhead = "1 0 0 2 0 1 0 0 0 0 1 0\n";
constexpr const char* kLidarLeft = "1 0 0 0 0 1 0 3 0 0 1 0\n";

TEST_F(PoseFile, OfKittiFormHoldsTheLidarsOwnPoses) {
  const ScanPoses poses = read(std::string("# LiDAR\n") + kLidarAhead + kLidarLeft);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_TRUE(pose(poses, 0).isApprox(turned_left(2.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(0.0, 3.0, 0.0), 1e-12));
}

TEST_F(PoseFile, HasALineForEveryNumberWhereItIsLongEnough) {
  const ScanPoses poses =
      read(std::string(kStart) + kStart + kStart + kLidarAhead + kLidarLeft + kStart);
  EXPECT_EQ(pose(poses, 0).translation(), Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_EQ(pose(poses, 1).translation(), Eigen::Vector3d(0.0, 3.0, 0.0));
}

TEST_F(PoseFile, MustMatchTheScans) {
  const std::string message = error(std::string(kStart) + kStart + kStart);
  EXPECT_TRUE(contains(message,
                       "drive.txt: expected a line for each of the 2 scans, or for every "
                       "number up to that of 4.bin, got 3 lines"));
}

TEST_F(PoseFile, HoldsTheCamerasPosesWhereThereIsAMounting) {
  write_file(folder / "drive.txt", std::string(kStart) + kTurnedLeft);
  write_file(folder / "mounting.txt", kCalibration);
  const ScanPoses poses =
      ScanPoses::from_file(folder / "drive.txt", sequence, folder / "mounting.txt");
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(0.27, -0.27, 90.0), 1e-12));
}

TEST_F(PoseFile, OfTumFormIsToldByItsNumbers) {
  // Half of the root of 2: 90° about z.
  const ScanPoses poses = read(
      "# time tx ty tz qx qy qz qw\n\n10 1 2 3 0 0 0 1\n10.5 4 5 6 0 0 0.70710678 0.70710678\n");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_TRUE(
      pose(poses, 0).isApprox(Eigen::Isometry3d(Eigen::Translation3d(1.0, 2.0, 3.0)), 1e-12));
  Eigen::Isometry3d left = turned_left(4.0, 5.0, 90.0);
  left.translation().z() = 6.0;
  EXPECT_TRUE(pose(poses, 1).isApprox(left, 1e-12));
}

TEST_F(PoseFile, IsInterpolatedAtTheTimesOfScans) {
  // The times of numbers 0 to 4.
  write_file(folder / "times.txt", "0.0\n0.5\n1.0\n1.25\n1.5\n");
  const ScanPoses poses =
      read("1 0 0 0 0 0 0 1\n2 4 8 0 0 0 0.70710678 0.70710678\n3 0 0 0 0 0 0 1\n");
  // A quarter and half of the way to (4, 8) and to 90°.
  EXPECT_TRUE(pose(poses, 0).isApprox(turned_left(1.0, 2.0, 22.5), 1e-9));
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(2.0, 4.0, 45.0), 1e-9));
}

TEST_F(PoseFile, IsInterpolatedTheShortWayRound) {
  write_file(folder / "times.txt", "1\n1.5\n");
  // The second quaternion is that of -90°, with the other sign.
  const ScanPoses poses = read("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0.70710678 -0.70710678\n");
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(0.0, 0.0, -45.0), 1e-9));
}

TEST_F(PoseFile, HoldsForATenthOfASecondMore) {
  write_file(folder / "times.txt", "0.9001\n3.0999\n");
  const std::string text = "1 7 0 0 0 0 0 1\n3 9 0 0 0 0 0 1\n";
  const ScanPoses poses = read(text);
  EXPECT_TRUE(pose(poses, 0).isApprox(turned_left(7.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(9.0, 0.0, 0.0), 1e-12));

  write_file(folder / "times.txt", "0.8999\n3.1001\n");
  const ScanPoses late = read(text);
  const std::string message = message_of<Error>([&] { (void)pose(late, 1); });
  EXPECT_TRUE(contains(message, "times.txt, line 2: expected a time within the poses of"));
  EXPECT_TRUE(contains(message, "drive.txt, from 1 to 3 s, got 3.1001 s"));
  EXPECT_TRUE(contains(message_of<Error>([&] { (void)pose(late, 0); }), "times.txt, line 1"));
}

TEST_F(PoseFile, NeedsATimeForEveryScan) {
  const std::string text = "1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n";
  write_file(folder / "times.txt", "1\n1.5\n1.75\n");
  EXPECT_TRUE(contains(error(text), "times.txt: expected a line for each of the 2 scans"));
  write_file(folder / "times.txt", "1\nsoon\n");
  EXPECT_TRUE(contains(error(text),
                       "times.txt, line 2: expected the time of a scan in seconds, got "
                       "'soon'"));
  write_file(folder / "times.txt", "1\ninf\n");
  EXPECT_TRUE(contains(error(text), "got 'inf'"));
  write_file(folder / "times.txt", "");
  EXPECT_TRUE(contains(error(text),
                       "times.txt: expected a line for each of the 2 scans, or for "
                       "every number up to that of 4.bin, got 0 lines"));
}

TEST_F(PoseFile, IsNotTakenWithoutTimesThatLeadNowhere) {
  std::filesystem::create_symlink("gone", folder / "times.txt");
  EXPECT_TRUE(contains(error("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n"),
                       "times.txt: expected a file, got nothing of that name"));
}

TEST_F(PoseFile, MayBeginWithAByteOrderMarkAndHavePluses) {
  const std::string mark = "\xEF\xBB\xBF";
  write_file(folder / "times.txt", mark + "+1.0e+00\n2\n");
  const ScanPoses tum = read(mark + "+1.0e+00 +7 -0 0 0 0 0 +1\n2 9 0 0 0 0 0 1\n");
  EXPECT_EQ(pose(tum, 0).translation(), Eigen::Vector3d(7.0, 0.0, 0.0));
  const ScanPoses kitti = read(mark + "+" + kLidarAhead + kLidarLeft);
  EXPECT_EQ(pose(kitti, 0).translation(), Eigen::Vector3d(2.0, 0.0, 0.0));
}

TEST_F(PoseFile, MustHoldPosesOfTum) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  EXPECT_TRUE(contains(error(good + "2 0 0 0 0 0 0 1.002\n"),
                       "drive.txt, line 2: expected a pose as time tx ty tz qx qy qz qw, with ever "
                       "later times, got a quaternion of length 1.002 instead of 1"));
  EXPECT_TRUE(contains(error(good + "1 0 0 0 0 0 0 1\n"), "line 2"));
  EXPECT_TRUE(contains(error(good + "0.5 0 0 0 0 0 0 1\n"), "got the time 0.5 s after 1 s"));
  EXPECT_TRUE(
      contains(error(good + "2 0 0 0 0 0 1\n"), "line 2: expected a pose as time tx ty tz "));
  EXPECT_TRUE(contains(error(good + "2 0 0 0 0 0 1\n"), "got 7 numbers"));
  EXPECT_TRUE(contains(error(good + "2 0 0 nan 0 0 0 1\n"), "got a number that is not finite"));
  EXPECT_TRUE(contains(error(good + "2 0 0 x 0 0 0 1\n"), "got something that is no number"));
  const ScanPoses rounded = read(good + "2 0 0 0 0 0 0 1.0009\n");
  EXPECT_TRUE(pose(rounded, 1).isApprox(Eigen::Isometry3d::Identity(), 1e-15));
}

TEST_F(PoseFile, MustHoldPoses) {
  EXPECT_TRUE(contains(error(""), "drive.txt: expected poses, one a line, got none"));
  EXPECT_TRUE(contains(error("# nothing\n\n"), "expected poses, one a line, got none"));
  EXPECT_TRUE(
      contains(error("# three\n1 2 3\n"),
               "line 2: expected the twelve numbers of a KITTI pose, or time tx ty tz qx qy "
               "qz qw, got 3 words"));
  EXPECT_TRUE(contains(error(std::string("# one\n") + kStart + "1 2\n"),
                       "line 3: expected the twelve numbers of a rigid transform, got 2 numbers"));
}

// Half of the root of 2: 90° about z, in the order of each form.
constexpr const char* kTumLeft = "0 0 0.70710678 0.70710678";
constexpr const char* kAslLeft = "0.70710678,0,0,0.70710678";

TEST_F(PoseFile, MayHaveMatricesOfFourRows) {
  const ScanPoses poses =
      read("1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n1 0 0 0 0 1 0 3 0 0 1 0 0 0 0 1\n");
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(0.0, 3.0, 0.0), 1e-12));
  EXPECT_TRUE(contains(error("1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 2\n"), "no rotation and translation"));
}

TEST_F(PoseFile, OfTumFormMayHaveAHeaderThatIsNoComment) {
  const ScanPoses poses = read(std::string("timestamp tx ty tz qx qy qz qw\n10 1 2 3 0 0 0 1\n") +
                               "10.5 4 5 0 " + kTumLeft + "\n");
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(4.0, 5.0, 90.0), 1e-12));
  EXPECT_TRUE(contains(error("10 1 2 3 0 0 0 1\ntimestamp tx ty tz qx qy qz qw\n"), "line 2"));
}

TEST_F(PoseFile, OfAslFormHasTheRealPartFirstAndNanoseconds) {
  write_file(folder / "times.txt", "1403636580.5\n1403636581\n");
  const std::string header =
      "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], "
      "q_RS_y [], q_RS_z []";
  const std::string velocity = ",0.1,0.2,0.3,0,0,0,0,0,0";
  for (const std::string& more : {std::string(), velocity}) {
    const ScanPoses poses = read(header + "\n1403636580000000000,0,0,0,1,0,0,0" + more + "\n" +
                                 "1403636581000000000, 4, 8, 0, " + kAslLeft + more + "\n");
    EXPECT_TRUE(pose(poses, 0).isApprox(turned_left(2.0, 4.0, 45.0), 1e-6));
    EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(4.0, 8.0, 90.0), 1e-6));
  }
}

TEST_F(PoseFile, WithCommasMaySayThatTheRealPartIsLast) {
  const ScanPoses poses =
      read("time,tx,ty,tz,qx,qy,qz,qw\n1.0,0,0,0,0,0,0,1\n2.0,4,8,0,0,0,0.70710678,0.70710678\n");
  EXPECT_TRUE(pose(poses, 1).isApprox(turned_left(4.0, 8.0, 90.0), 1e-12));
  EXPECT_TRUE(contains(error("1.0,0,0,0,1,0,0,0\n2.0,0,0,0,1,0,0,x\n"),
                       "line 2: expected a pose as time tx ty tz qw qx qy qz"));
}

TEST_F(PoseFile, WithNumbersBelongsToTheScansOfThese) {
  const ScanPoses poses = read("1 1 0 0 7 0 1 0 0 0 0 1 0\n4 1 0 0 2 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(pose(poses, 1).translation(), Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_FALSE(poses.leaves_out(sequence.scans[1]));
  // Nothing is made up for what stands between two lines.
  EXPECT_TRUE(poses.leaves_out(sequence.scans[0]));
  EXPECT_TRUE(contains(message_of<Error>([&] { (void)pose(poses, 0); }),
                       "drive.txt: expected a line for scan number 3, got none"));
  const ScanPoses of_four_rows = read("4 1 0 0 2 0 1 0 0 0 0 1 0 0 0 0 1\n");
  EXPECT_EQ(pose(of_four_rows, 1).translation(), Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_FALSE(read(std::string(kLidarAhead) + kLidarLeft).leaves_out(sequence.scans[0]));
}

TEST_F(PoseFile, WithNumbersHasThemInOrderAndOneOfAScan) {
  const std::string rest = " 1 0 0 7 0 1 0 0 0 0 1 0\n";
  EXPECT_TRUE(contains(error("3" + rest + "3" + rest),
                       "line 2: expected the number of a scan, "
                       "greater than the one before, and its pose, "
                       "got '3'"));
  EXPECT_TRUE(contains(error("3" + rest + "4.5" + rest), "got '4.5'"));
  EXPECT_TRUE(contains(error("0" + rest + "9" + rest),
                       "expected a line for any of the scans 3 to 4, got lines for the numbers 0 "
                       "to 9"));
}

/// A KITTI-360 dataset of two scans. Its vehicle's frame is x ahead, y right, z down, its LiDAR
/// 1 m behind the camera and 0.5 m above it, the camera 2 m before the vehicle's origin.
class Kitti360Poses : public ::testing::Test {
 protected:
  Kitti360Poses() {
    for (const char* const name : {"0000000000.bin", "0000000002.bin"})
      write_file(folder / "data_3d_raw/drive/velodyne_points/data" / name, "");
    // Ahead along the map's y.
    write_file(folder / "data_poses/drive/poses.txt", "2 0 1 0 10 1 0 0 20 0 0 -1 1.5\n");
  }

  void write_calibration() const {
    write_file(folder / "calibration/calib_cam_to_pose.txt",
               "image_00: 0 0 1 2 1 0 0 0 0 1 0 0\nimage_01: 0 0 1 9 1 0 0 9 0 1 0 9\n");
    write_file(folder / "calibration/calib_cam_to_velo.txt", "0 0 1 1 -1 0 0 0 0 -1 0 -0.5\n");
  }

  [[nodiscard]] ScanSequence sequence(const std::string& below = "") const {
    return find_sequences(folder / below).front();
  }

  test::TemporaryFolder folder;
};

TEST_F(Kitti360Poses, AreTheLidarsInAMapWhoseZIsUp) {
  write_calibration();
  for (const char* const below : {"", "data_3d_raw", "data_3d_raw/drive"}) {
    const ScanSequence found = sequence(below);
    EXPECT_EQ(found.name, "drive");
    ASSERT_EQ(found.scans.size(), 2U);
    const ScanPoses poses = ScanPoses::of_dataset(found);
    EXPECT_TRUE(poses.leaves_out(found.scans[0]));
    Eigen::Isometry3d expected = turned_left(10.0, 21.0, 90.0);
    expected.translation().z() = 2.0;
    EXPECT_TRUE(poses.pose(found.scans[1]).isApprox(expected, 1e-12));
    const ScanPoses same = ScanPoses::from_file(found.poses(), found, folder / "calibration");
    EXPECT_TRUE(same.pose(found.scans[1]).isApprox(expected, 1e-12));
  }
}

TEST_F(Kitti360Poses, AreTakenAsTheyAreWithoutACalibration) {
  const ScanSequence found = sequence();
  EXPECT_EQ(ScanPoses::of_dataset(found).pose(found.scans[1]).translation(),
            Eigen::Vector3d(10.0, 20.0, 1.5));
}

TEST_F(Kitti360Poses, NeedAWholeCalibrationIfThereIsOne) {
  const auto problem = [&] {
    return message_of<Error>([&] { ScanPoses::of_dataset(sequence()); });
  };
  write_calibration();
  write_file(folder / "calibration/calib_cam_to_velo.txt", "");
  EXPECT_TRUE(
      contains(problem(), "calib_cam_to_velo.txt: expected a line with the twelve numbers"));
  write_file(folder / "calibration/calib_cam_to_pose.txt", "image_01: 0 0 1 9 1 0 0 9 0 1 0 9\n");
  EXPECT_TRUE(contains(problem(), "calib_cam_to_pose.txt: expected a line 'image_00:'"));
}

using RealPoses = test::WithSharedData;

TEST_F(RealPoses, OfTheOdometrySetAreOnlyMetresApart) {
  const ScanSequence sequence =
      find_sequences(data() / "semantickitti", std::vector<std::string>{"09"}).front();
  const ScanPoses poses = ScanPoses::kitti(sequence.poses(), sequence.calibration());
  EXPECT_EQ(poses.size(), 1591U);
  EXPECT_LT(poses.pose(sequence.scans[0]).translation().norm(), 1e-6);
  // Ten scans at 10 Hz in a village: the vehicle moves 2.8 m.
  EXPECT_NEAR(poses.pose(sequence.scans[9]).translation().norm(), 2.8, 0.05);
  const ScanPoses same = ScanPoses::from_file(sequence.poses(), sequence, sequence.calibration());
  EXPECT_TRUE(same.pose(sequence.scans[9]).isApprox(poses.pose(sequence.scans[9]), 1e-15));
}

using OversizedPoseFile = test::OversizedFile;

TEST_F(OversizedPoseFile, IsNamed) {
  test::make_sparse_file(folder / "poses.txt", kBytes);
  EXPECT_TRUE(contains(
      message_of<Error>([&] { ScanPoses::kitti(folder / "poses.txt", folder / "calib.txt"); }),
      "poses.txt: expected a file that fits into memory"));
}

}  // namespace
}  // namespace groundgrid::io
