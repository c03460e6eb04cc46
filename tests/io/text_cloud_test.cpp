#include "io/text_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cloud_checks.hpp"
#include "io/scan_sequence.hpp"
#include "oversized_file.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::Names;
using test::names_of;
using test::values_of;
using Values = std::vector<double>;

PointCloud read_lines(std::string_view content) {
  return test::read_content(content, ScanFormat::text);
}

std::string error_in_lines(std::string_view content) {
  return test::error_in(content, ScanFormat::text);
}

TEST(TextCloud, MaySeparateItsColumnsByBlanksTabsCommasOrSemicolons) {
  for (const std::string content :
       {"1 2 -3 0.5\n4.5e1 5 +6 1\n", "1\t2\t-3\t0.5\r\n45\t5\t6\t1\r\n", "1,2,-3,0.5\n45, 5, 6, 1",
        "1;2;-3;0.5\n\n45 ; 5 ; 6 ; 1\n", "\xEF\xBB\xBF 1 2 -3 0.5\n45 5 6 1\n"}) {
    const PointCloud cloud = read_lines(content);
    EXPECT_EQ(names_of(cloud), (Names{"x", "y", "z", "intensity"})) << content;
    EXPECT_EQ(values_of(cloud, "x"), (Values{1, 45})) << content;
    EXPECT_EQ(values_of(cloud, "z"), (Values{-3, 6})) << content;
    EXPECT_EQ(values_of(cloud, "intensity"), (Values{0.5, 1})) << content;
    EXPECT_EQ(cloud.encoding, CloudEncoding::ascii);
  }
}

TEST(TextCloud, HasUsualColumnsWithoutNames) {
  EXPECT_EQ(names_of(read_lines("1 2 3\n")), (Names{"x", "y", "z"}));
  EXPECT_EQ(names_of(read_lines("1 2 3 4 5 6\n")), (Names{"x", "y", "z", "r", "g", "b"}));
  EXPECT_EQ(names_of(read_lines("1 2 3 4 5 6 7\n")),
            (Names{"x", "y", "z", "intensity", "r", "g", "b"}));
  EXPECT_TRUE(contains(error_in_lines("# poses\n0 1 2 3 0 0 0 1\n"),
                       "line 2: expected x y z, x y z intensity, x y z r g b or x y z intensity r "
                       "g b, got 8 columns without names; name the columns"));
}

TEST(TextCloud, MayNameItsColumns) {
  const PointCloud cloud = read_lines("time, X,Y , Z,ring\n1400000000.25,1,2,3,7\n");
  EXPECT_EQ(names_of(cloud), (Names{"time", "x", "y", "z", "ring"}));
  EXPECT_EQ(values_of(cloud, "time"), Values{1400000000.25});
  EXPECT_EQ(names_of(read_lines("//X Y Z Intensity\n1\n1 2 3 4\n")),
            (Names{"x", "y", "z", "Intensity"}));
  EXPECT_EQ(names_of(read_lines("# a drive\n# x;y;z;solar angle\n1;2;3;4\n")),
            (Names{"x", "y", "z", "solar angle"}));
  EXPECT_EQ(names_of(read_lines("\"intensity\",\"Points_m_XYZ:0\",\"Points_m_XYZ:1\",\"Points_m_"
                                "XYZ:2\"\n4,1,2,3\n")),
            (Names{"intensity", "x", "y", "z"}));
}

TEST(TextCloud, MaySayHowManyPointsItHas) {
  EXPECT_EQ(read_lines("2\n1 2 3\n4 5 6\n").size(), 2U);
  EXPECT_TRUE(contains(error_in_lines("3\n1 2 3\n4 5 6\n"), "expected 3 points"));
  EXPECT_TRUE(
      contains(error_in_lines("1\n1 2 3\n4 5 6\n"), "line 3: expected the end of the file"));
}

TEST(TextCloud, KeepsPointsThatAreNoNumbers) {
  const PointCloud cloud = read_lines("1 2 3\nnan inf -1\n");
  EXPECT_TRUE(std::isnan(values_of(cloud, "x")[1]));
  EXPECT_TRUE(std::isinf(values_of(cloud, "y")[1]));
}

TEST(TextCloud, MayBeEmpty) {
  for (const char* const content : {"", "# x y z\n", "x,y,z\n", "0\n"}) {
    EXPECT_EQ(read_lines(content).size(), 0U) << content;
    EXPECT_EQ(read_lines(content).fields.size(), 3U) << content;
  }
}

TEST(TextCloud, SaysWhichLineIsNoPoint) {
  EXPECT_TRUE(contains(error_in_lines("1 2 3\n\n4 5\n"),
                       "line 3: expected a float64 for 'z', got the end of the line"));
  EXPECT_TRUE(contains(error_in_lines("1 2 3\n4 5 6 7\n"), "line 2: expected 3 numbers, got more"));
  EXPECT_TRUE(contains(error_in_lines("1,2,3,4\n1,,3,4\n"), "line 2"));
  EXPECT_TRUE(contains(error_in_lines("1 2 3\n4 b 6\n"), "got 'b'"));
  EXPECT_TRUE(contains(error_in_lines("1,5;2,5;3,5\n"),
                       "line 1: expected numbers with decimal points, got decimal commas"));
  EXPECT_TRUE(contains(error_in_lines("lat lon\n1 2 3\n"),
                       "line 1: expected the numbers of a point, or names of columns with x, y and "
                       "z among them, got 'lat lon'"));
  EXPECT_TRUE(contains(error_in_lines("x y z x\n1 2 3 4\n"), "got 'x' twice"));
}

TEST(TextCloud, IsToldFromAListByItsLines) {
  const test::TemporaryFolder folder;
  const auto looks_like_a_cloud = [&](const std::string& text) {
    test::write_file(folder / "a.txt", text);
    return is_text_cloud(folder / "a.txt");
  };
  EXPECT_TRUE(looks_like_a_cloud("# a\n1 2 3 4\n"));
  EXPECT_TRUE(looks_like_a_cloud("x y z\n"));
  EXPECT_TRUE(looks_like_a_cloud("1\n1 2 3\n"));
  EXPECT_FALSE(looks_like_a_cloud("# scans\n000000.bin\n"));
  EXPECT_FALSE(looks_like_a_cloud("000000\n000001\n"));
  EXPECT_FALSE(looks_like_a_cloud("1 0 0 0 0 1 0 0 0 0 1 0\n")) << "a pose";
  EXPECT_FALSE(looks_like_a_cloud(""));
  EXPECT_FALSE(is_text_cloud(folder / "none.txt"));
}

TEST(TextCloud, IsFoundByItsEnding) {
  const test::TemporaryFolder folder;
  const auto scans = [&] { return find_sequences(folder.path()).front().scans; };
  test::write_file(folder / "imu.csv", "");
  test::write_file(folder / "0.txt", "1 2 3\n");
  EXPECT_EQ(scans().size(), 2U);
  EXPECT_EQ(scans()[0].format, ScanFormat::text);
  EXPECT_EQ(find_sequences(folder / "0.txt").front().scans[0].format, ScanFormat::text);
  EXPECT_EQ(find_sequences(folder / "imu.csv").front().scans[0].name, "imu");
  test::write_file(folder / "list.txt", "imu.csv\n0.txt\n");
  EXPECT_EQ(find_sequences(folder / "list.txt").front().scans.size(), 2U);
  // Beside other scans they are something else.
  test::write_file(folder / "1.XYZ", "");
  test::write_file(folder / "2.pts", "");
  ASSERT_EQ(scans().size(), 2U);
  EXPECT_EQ(scans()[0].name, "1");
  EXPECT_EQ(scans()[1].name, "2");
}

using OversizedTextCloud = test::OversizedFile;

TEST_F(OversizedTextCloud, IsNamed) {
  test::make_sparse_file(folder / "huge.xyz", kBytes);
  EXPECT_TRUE(contains(test::error_of(folder / "huge.xyz", ScanFormat::text),
                       "expected a file that fits into memory"));
}

}  // namespace
}  // namespace groundgrid::io
