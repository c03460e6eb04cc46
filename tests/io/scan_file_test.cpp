#include "io/scan_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cloud_checks.hpp"
#include "io/labelled_cloud.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::error_of;
namespace fs = std::filesystem;

class ScanFileOf : public ::testing::TestWithParam<ScanFormat> {
 protected:
  test::TemporaryFolder folder;
};

TEST_P(ScanFileOf, IsAFile) {
  EXPECT_TRUE(contains(error_of(folder / "none", GetParam()),
                       "none: expected a file, got nothing of that name"));
  EXPECT_TRUE(contains(error_of(folder.path(), GetParam()), "expected a file, got a directory"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(contains(error_of(folder / "pipe", GetParam()),
                       "expected a regular file, got a device, pipe or socket"));
  fs::create_symlink(folder / "a", folder / "b");
  fs::create_symlink(folder / "b", folder / "a");
  EXPECT_TRUE(contains(error_of(folder / "a", GetParam()),
                       "expected a regular file, got Too many levels of symbolic links"));
}

TEST_P(ScanFileOf, LeavesTheCloudEmptyWhereItCannotBeRead) {
  test::write_file(folder / "wrong", "neither of the formats");
  PointCloud cloud = test::read_content(std::string(32, '\0'), ScanFormat::kitti);
  EXPECT_THROW(read_scan(folder / "wrong", GetParam(), cloud), Error);
  EXPECT_EQ(cloud.size(), 0U);
  EXPECT_TRUE(cloud.fields.empty());
  EXPECT_TRUE(cloud.data.empty());
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, ScanFileOf,
                         ::testing::Values(ScanFormat::kitti, ScanFormat::nuscenes, ScanFormat::pcd,
                                           ScanFormat::ply, ScanFormat::text),
                         [](const auto& instance) { return std::string(name_of(instance.param)); });

TEST(ScanFile, ReusesTheMemoryOfTheLastScan) {
  const test::TemporaryFolder folder;
  const PointCloud written = test::read_content(std::string(160, '\0'), ScanFormat::kitti);
  const std::vector<std::uint32_t> labels(10);
  const std::vector<float> heights(10);
  write_labelled_cloud(folder / "a.pcd", ScanFormat::pcd, written, labels, heights);
  write_labelled_cloud(folder / "a.ply", ScanFormat::ply, written, labels, heights);
  PointCloud cloud;
  read_scan(folder / "a.pcd", ScanFormat::pcd, cloud);
  const std::byte* const memory = cloud.data.data();
  read_scan(folder / "a.ply", ScanFormat::ply, cloud);
  EXPECT_EQ(cloud.size(), 10U);
  EXPECT_EQ(cloud.data.data(), memory);
}

}  // namespace
}  // namespace groundgrid::io
