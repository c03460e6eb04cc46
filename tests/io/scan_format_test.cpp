#include "io/scan_format.hpp"

#include <gtest/gtest.h>

namespace groundgrid::io {
namespace {

TEST(ScanFormat, IsFoundByTheEndingOfTheName) {
  EXPECT_EQ(format_by_name("a/000000.bin"), ScanFormat::kitti);
  EXPECT_EQ(format_by_name("1532402927647951.pcd.bin"), ScanFormat::nuscenes);
  EXPECT_EQ(format_by_name("b.pcd"), ScanFormat::pcd);
  EXPECT_EQ(format_by_name("x.pcd/b.ply"), ScanFormat::ply);
}

TEST(ScanFormat, IsFoundWhateverTheCaseOfTheEnding) {
  EXPECT_EQ(format_by_name("000000.BIN"), ScanFormat::kitti);
  EXPECT_EQ(format_by_name("1.PCD.Bin"), ScanFormat::nuscenes);
  EXPECT_EQ(format_by_name("b.Pcd"), ScanFormat::pcd);
  EXPECT_EQ(format_by_name("b.PLY"), ScanFormat::ply);
  EXPECT_EQ(scan_stem("Scan.PCD.BIN"), "Scan");
}

TEST(ScanFormat, IsNoneForHiddenFilesAndOtherEndings) {
  for (const char* const name : {".a.bin", ".pcd.bin", ".ply", "a.txt", "pcd", "", "a/"})
    EXPECT_FALSE(format_by_name(name)) << name;
}

TEST(ScanFormat, HasANameThatFindsIt) {
  for (const ScanFormat format : {ScanFormat::kitti, ScanFormat::nuscenes, ScanFormat::pcd,
                                  ScanFormat::ply, ScanFormat::text})
    EXPECT_EQ(scan_format_named(name_of(format)), format);
  EXPECT_EQ(name_of(ScanFormat::nuscenes), "nuscenes");
  EXPECT_EQ(name_of(*scan_format_named("xyzirt")), "xyzirt");
  EXPECT_EQ(scan_format_named("xyzi"), ScanFormat::kitti);
  EXPECT_EQ(scan_format_named("xyzir"), ScanFormat::nuscenes);
  EXPECT_FALSE(scan_format_named("las"));
  EXPECT_FALSE(scan_format_named(""));
}

TEST(ScanFormat, LeavesTheStemOfAName) {
  EXPECT_EQ(scan_stem("a/000042.bin"), "000042");
  EXPECT_EQ(scan_stem("1532402927647951.pcd.bin"), "1532402927647951");
  EXPECT_EQ(scan_stem("a.b.ply"), "a.b");
  EXPECT_EQ(scan_stem("scan.dat"), "scan");
}

}  // namespace
}  // namespace groundgrid::io
