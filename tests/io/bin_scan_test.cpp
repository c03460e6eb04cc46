#include "io/bin_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cloud_checks.hpp"
#include "io/error.hpp"
#include "io/scan_file.hpp"
#include "oversized_file.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::error_of;
using test::expect_values_between;
using test::message_of;
using test::names_of;

TEST(BinScan, RejectsATruncatedFileAndSaysWhere) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "cut.bin", std::string(16 * 3 + 5, 'x'));
  PointCloud points;
  const std::string message =
      message_of<Error>([&] { read_bin_scan(folder / "cut.bin", kKittiLayout, points); });
  EXPECT_TRUE(contains(message, (folder / "cut.bin").string()));
  EXPECT_TRUE(contains(message, "byte 48"));
  EXPECT_TRUE(contains(message, "got 5 bytes"));
}

TEST(BinScan, RejectsWhatIsNoFile) {
  const test::TemporaryFolder folder;
  PointCloud points;
  EXPECT_TRUE(
      contains(message_of<Error>([&] { read_bin_scan(folder / "none.bin", kKittiLayout, points); }),
               "none.bin: expected a file, got nothing of that name"));
  EXPECT_TRUE(
      contains(message_of<Error>([&] { read_bin_scan(folder.path(), kKittiLayout, points); }),
               "expected a file, got a directory"));
  EXPECT_TRUE(contains(message_of<Error>([&] { read_bin_scan("/dev/null", kKittiLayout, points); }),
                       "expected a regular file"));
}

TEST(BinScan, KeepsAllFieldsOfAKittiScan) {
  const test::TemporaryFolder folder;
  test::write_numbers<float>(folder / "scan.bin", {1, 2, 3, 0.5F, -1, -2, -3, 0.25F});
  PointCloud cloud;
  read_scan(folder / "scan.bin", ScanFormat::kitti, cloud);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "intensity"}));
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud.stride_bytes, 16U);
  EXPECT_EQ(value_at(cloud, 0, *cloud.find("intensity")), 0.5);
  EXPECT_EQ(value_at(cloud, 1, *cloud.find("z")), -3.0);
}

TEST(BinScan, KeepsAllFieldsOfANuscenesScan) {
  const test::TemporaryFolder folder;
  test::write_numbers<float>(folder / "scan.pcd.bin", {1, 2, 3, 77, 31, -1, -2, -3, 78, 0});
  PointCloud cloud;
  read_scan(folder / "scan.pcd.bin", ScanFormat::nuscenes, cloud);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "intensity", "ring"}));
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(value_at(cloud, 0, *cloud.find("ring")), 31.0);
  EXPECT_EQ(value_at(cloud, 1, *cloud.find("x")), -1.0);
}

TEST(BinScan, PassesOverTheNumbersThatItsLayoutDoesNotName) {
  const test::TemporaryFolder folder;
  test::write_numbers<double>(folder / "scan.bin", {9, 1, 2, 3, 8, 0.5, 9, -1, -2, -3, 8, 0.25});
  PointCloud cloud;
  read_scan(folder / "scan.bin", *scan_format_named("_xyz_i:f64"), cloud);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "intensity"}));
  EXPECT_EQ(test::values_of(cloud, "x"), (std::vector<double>{1, -1}));
  EXPECT_EQ(test::values_of(cloud, "intensity"), (std::vector<double>{0.5, 0.25}));
}

TEST(BinScan, KeepsPointsThatAreNoNumbers) {
  const test::TemporaryFolder folder;
  test::write_numbers<float>(folder / "scan.bin",
                             {std::nanf(""), 2, std::numeric_limits<float>::infinity(), 0.5F});
  PointCloud cloud;
  read_scan(folder / "scan.bin", ScanFormat::kitti, cloud);
  EXPECT_TRUE(std::isnan(value_at(cloud, 0, *cloud.find("x"))));
  EXPECT_TRUE(std::isinf(value_at(cloud, 0, *cloud.find("z"))));
}

TEST(BinScan, ForgetsTheLastCloud) {
  const test::TemporaryFolder folder;
  test::write_numbers<float>(folder / "scan.pcd.bin", {1, 2, 3, 77, 31});
  test::write_file(folder / "empty.bin", "");
  PointCloud cloud;
  read_scan(folder / "scan.pcd.bin", ScanFormat::nuscenes, cloud);
  read_scan(folder / "empty.bin", ScanFormat::kitti, cloud);
  EXPECT_EQ(cloud.size(), 0U);
  EXPECT_EQ(cloud.fields.size(), 4U);
  EXPECT_TRUE(cloud.data.empty());
  EXPECT_THROW(read_scan(folder / "none.bin", ScanFormat::kitti, cloud), Error);
  EXPECT_TRUE(cloud.fields.empty());
}

TEST(BinScan, SaysWhereAnotherFormatFits) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "20.bin", std::string(20, 'x'));
  test::write_file(folder / "16.bin", std::string(16, 'x'));
  test::write_file(folder / "17.bin", std::string(17, 'x'));
  EXPECT_TRUE(contains(error_of(folder / "20.bin", ScanFormat::kitti), "use --format nuscenes"));
  EXPECT_TRUE(contains(error_of(folder / "16.bin", ScanFormat::nuscenes), "use --format kitti"));
  const std::string message = error_of(folder / "17.bin", ScanFormat::nuscenes);
  EXPECT_TRUE(contains(message, "byte 0: expected whole points of 20 bytes"));
  EXPECT_TRUE(contains(message, "cut short"));
}

TEST(BinScan, SaysWhereTheFileIsOneOfAnotherFormat) {
  const test::TemporaryFolder folder;
  const std::string blanks(32, ' ');
  test::write_file(folder / "a.bin", "# .PCD v0.7" + blanks);
  test::write_file(folder / "b.bin", "VERSION 0.7" + blanks);
  test::write_file(folder / "c.bin", "ply\nformat " + blanks);
  test::write_file(folder / "d.bin", "ply\r\nformat " + blanks);
  EXPECT_TRUE(contains(error_of(folder / "a.bin", ScanFormat::kitti), "use --format pcd"));
  EXPECT_TRUE(contains(error_of(folder / "b.bin", ScanFormat::kitti), "use --format pcd"));
  EXPECT_TRUE(contains(error_of(folder / "c.bin", ScanFormat::nuscenes), "use --format ply"));
  EXPECT_TRUE(contains(error_of(folder / "d.bin", ScanFormat::kitti), "use --format ply"));
}

using RealBinScan = test::WithSharedData;

TEST_F(RealBinScan, OfKittiIsWhole) {
  PointCloud cloud;
  read_scan(data() / "semantickitti/sequences/00/velodyne/000000.bin", ScanFormat::kitti, cloud);
  EXPECT_EQ(cloud.size(), 124668U);
  expect_values_between(cloud, "x", -120, 120);
  expect_values_between(cloud, "intensity", 0, 1);
}

TEST_F(RealBinScan, OfNuscenesIsWhole) {
  PointCloud cloud;
  read_scan(data() / "sensors/nuscenes_HDL32_1532402927647951.pcd.bin", ScanFormat::nuscenes,
            cloud);
  EXPECT_EQ(cloud.size(), 34688U);
  expect_values_between(cloud, "z", -10, 30);
  expect_values_between(cloud, "intensity", 0, 255);
  expect_values_between(cloud, "ring", 0, 31);
}

using OversizedScan = test::OversizedFile;

TEST_F(OversizedScan, IsNamed) {
  test::make_sparse_file(folder / "huge.bin", kBytes);
  EXPECT_TRUE(contains(error_of(folder / "huge.bin", ScanFormat::kitti),
                       "expected a file that fits into memory, got 17179869184 bytes"));
}

}  // namespace
}  // namespace groundgrid::io
