#include "io/pcd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "cloud_checks.hpp"
#include "io/error.hpp"
#include "oversized_file.hpp"
#include "pcd_content.hpp"
#include "shared_data.hpp"

namespace groundgrid::io {
namespace {

using test::bytes_of;
using test::contains;
using test::error_in_pcd;
using test::expect_values_between;
using test::names_of;
using test::read_pcd;
using test::values_of;
using namespace std::string_literals;

using Values = std::vector<double>;

// x y z as floats, with what the header says of their number.
std::string xyz(const std::string& shape, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
         "TYPE F F F\nCOUNT 1 1 1\n" +
         shape + "DATA " + data;
}

TEST(PcdAscii, IsReadWithEveryType) {
  const PointCloud cloud = read_pcd(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z a b c d e f g h\nSIZE 4 8 4 1 1 2 2 4 4 8 8\nTYPE F F F I U I U I U I U\n"
      "COUNT 1 1 1 1 1 1 1 1 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\nPOINTS 1\n"
      "DATA ascii\n"
      "1.5 -2.25 3e2 -128 255 -32768 65535 -2147483648 4294967295 -9007199254740991 "
      "9007199254740991\n");
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "a", "b", "c", "d", "e", "f", "g", "h"}));
  EXPECT_EQ(cloud.encoding, CloudEncoding::ascii);
  EXPECT_EQ(cloud.viewpoint, "1 2 3 1 0 0 0");
  EXPECT_EQ(cloud.stride_bytes, 46U);
  const Values expected{1.5,
                        -2.25,
                        300.0,
                        -128.0,
                        255.0,
                        -32768.0,
                        65535.0,
                        -2147483648.0,
                        4294967295.0,
                        -9007199254740991.0,
                        9007199254740991.0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(value_at(cloud, 0, cloud.fields[i]), expected[i]) << cloud.fields[i].name;
}

TEST(PcdAscii, KeepsWhatIsNoNumber) {
  const PointCloud cloud = read_pcd(xyz("WIDTH 2\n", "ascii\nnan -inf NaN\n-nan inf +Infinity\n"));
  EXPECT_TRUE(std::isnan(values_of(cloud, "x")[0]));
  EXPECT_EQ(values_of(cloud, "y"), (Values{-HUGE_VAL, HUGE_VAL}));
  EXPECT_TRUE(std::isnan(values_of(cloud, "z")[0]));
  EXPECT_TRUE(std::signbit(values_of(cloud, "x")[1]));
  EXPECT_EQ(values_of(cloud, "z")[1], HUGE_VAL);
}

TEST(PcdAscii, TakesLineEndsBlanksAndCommentsAsTheyCome) {
  const PointCloud cloud = read_pcd(
      "# a comment\r\n\r\nVERSION .7\r\nFIELDS  x\ty z\r\n# another\r\nSIZE 4 4 4\r\nTYPE F F F\r\n"
      "WIDTH 2\r\nDATA ascii\r\n\r\n  1\t2  3 \r\n\r\n+4 5 6");
  EXPECT_EQ(values_of(cloud, "x"), (Values{1.0, 4.0}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{3.0, 6.0}));
}

TEST(PcdAscii, TakesWholeNumbersThatAreWrittenAsFloats) {
  const PointCloud cloud = read_pcd(
      "FIELDS x y z ring\nSIZE 4 4 4 1\nTYPE F F F U\nWIDTH 2\nDATA ascii\n"
      "0 0 0 3.0\n0 0 0 2.55e2\n");
  EXPECT_EQ(values_of(cloud, "ring"), (Values{3.0, 255.0}));
}

TEST(PcdAscii, TakesWhatANumberDoesNotHoldAsZeroOrInfinite) {
  for (const std::string size : {"4", "8"})
    for (const std::string exponent : {"999", "99999999999999999999"}) {
      const PointCloud cloud = read_pcd("FIELDS x y z\nSIZE " + size + " " + size + " " + size +
                                        "\nTYPE F F F\nWIDTH 1\nDATA ascii\n1e-" + exponent +
                                        " +1e" + exponent + " -1e" + exponent + "\n");
      EXPECT_EQ(values_of(cloud, "x")[0], 0.0) << size;
      EXPECT_EQ(values_of(cloud, "y")[0], HUGE_VAL) << size;
      EXPECT_EQ(values_of(cloud, "z")[0], -HUGE_VAL) << size;
    }
  // A double holds these, a float does not.
  const PointCloud cloud = read_pcd(xyz("WIDTH 1\n", "ascii\n1e-60 1e60 -1e60\n"));
  EXPECT_EQ(values_of(cloud, "x")[0], 0.0);
  EXPECT_EQ(values_of(cloud, "y")[0], HUGE_VAL);
  EXPECT_EQ(values_of(cloud, "z")[0], -HUGE_VAL);
}

TEST(PcdAscii, RejectsWhatDoesNotFitTheField) {
  const std::string header =
      "FIELDS x y z ring\nSIZE 4 4 4 1\nTYPE F F F U\nWIDTH 2\nDATA ascii\n0 0 0 3\n";
  for (const std::string word :
       {"256", "-1", "2.5", "nan", "x", "3x", "1e99", "1e999", "0x3", "++3"})
    EXPECT_TRUE(contains(error_in_pcd(header + "0 0 0 " + word + "\n"),
                         "scan, line 7: expected a uint8 for 'ring', got '" + word + "'"));
  for (const std::string word : {"1e999x", "++1", "+-1", "1,5"})
    EXPECT_TRUE(contains(error_in_pcd(header + "0 0 " + word + " 3\n"),
                         "a float32 for 'z', got '" + word + "'"));
  EXPECT_TRUE(contains(error_in_pcd(header + "0.0 0.0 0.0\n"),
                       "line 7: expected a uint8 for 'ring', got the "
                       "end of the line"));
  EXPECT_TRUE(
      contains(error_in_pcd(header + "0 0 0 3 7\n"), "line 7: expected 4 numbers, got more: '7'"));
}

TEST(PcdAscii, HasAsManyLinesAsTheHeaderPromises) {
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 3\n", "ascii\n10.000 20.000 30.000\n\n4 5 6\n")),
                       "line 11: expected 3 points, as the header promises, got the end of the "
                       "file after 2"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 1\n", "ascii\n1 2 3\n4 5 6\n")),
                       "line 10: expected the end of the file"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 1152921504606846976\n", "ascii\n1 2 3\n")),
                       "expected 1152921504606846976 points, as the header promises, got 6 bytes "
                       "of text, which hold 1 at most"));
}

TEST(PcdBinary, IsReadAsItLies) {
  const std::string points = bytes_of({1, 2, 3, 4, 5, 6});
  const PointCloud cloud = read_pcd(xyz("WIDTH 2\nHEIGHT 1\nPOINTS 2\n", "binary\n" + points));
  EXPECT_EQ(cloud.encoding, CloudEncoding::binary);
  ASSERT_EQ(cloud.data.size(), points.size());
  EXPECT_EQ(std::memcmp(cloud.data.data(), points.data(), points.size()), 0);
}

TEST(PcdBinary, CountsTheBytesAfterTheLastPoint) {
  const PointCloud cloud = read_pcd(xyz("WIDTH 1\n", "binary\r\n" + bytes_of({1, 2, 3, 4})));
  EXPECT_EQ(cloud.size(), 1U);
  EXPECT_EQ(cloud.surplus_bytes, 4U);
  EXPECT_EQ(read_pcd(xyz("WIDTH 1\n", "binary\n" + bytes_of({1, 2, 3}))).surplus_bytes, 0U);
  EXPECT_EQ(read_pcd(xyz("WIDTH 0\n", "binary\n" + bytes_of({1, 2, 3}))).surplus_bytes, 12U);
  EXPECT_EQ(read_pcd(xyz("WIDTH 1\n", "ascii\n1 2 3\n\n")).surplus_bytes, 0U);
}

TEST(PcdBinary, LeavesPaddingOut) {
  const std::string header =
      "VERSION 0.7\nFIELDS x y z _ ring _ normal\nSIZE 4 4 4 1 2 1 4\nTYPE F F F U U U F\n"
      "COUNT 1 1 1 4 1 2 2\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n";
  const std::string first = bytes_of({1, 2, 3}) + "pppp" + "\x07\x01"s + "qq" + bytes_of({8, 9});
  const std::string second = bytes_of({4, 5, 6}) + "pppp" + "\x08\x00"s + "qq" + bytes_of({-8, -9});
  const PointCloud cloud = read_pcd(header + first + second);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "ring", "normal"}));
  EXPECT_EQ(cloud.stride_bytes, 22U);
  EXPECT_EQ(cloud.data.size(), 44U);
  EXPECT_EQ(values_of(cloud, "z"), (Values{3.0, 6.0}));
  EXPECT_EQ(values_of(cloud, "ring"), (Values{263.0, 8.0}));
  EXPECT_EQ(values_of(cloud, "normal"), (Values{8.0, -8.0}));
  EXPECT_EQ(cloud.find("normal")->count, 2U);
}

TEST(PcdAscii, LeavesPaddingOut) {
  const PointCloud cloud = read_pcd(
      "FIELDS _ x y z\nSIZE 1 4 4 4\nTYPE U F F F\nCOUNT 2 1 1 1\nWIDTH 2\nDATA ascii\n"
      "0 0 1 2 3\n0 0 4 5 6\n");
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z"}));
  EXPECT_EQ(values_of(cloud, "x"), (Values{1.0, 4.0}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{3.0, 6.0}));
}

TEST(PcdBinary, HoldsWhatTheHeaderPromises) {
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 3\n", "binary\n" + bytes_of({1, 2, 3, 4, 5}))),
                       ": expected 3 points of 12 bytes, as the header promises, got 20 bytes, "
                       "which hold 1; the file is cut short"));
  EXPECT_TRUE(
      contains(error_in_pcd(xyz("WIDTH 1152921504606846976\n", "binary\n" + bytes_of({1, 2, 3}))),
               "expected 1152921504606846976 points"));
}

TEST(PcdShape, MayBeOrganised) {
  const PointCloud cloud = read_pcd(
      xyz("WIDTH 3\nHEIGHT 2\nPOINTS 6\n", "ascii\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n5 0 0\n6 0 0\n"));
  EXPECT_EQ(cloud.width, 3U);
  EXPECT_EQ(cloud.height, 2U);
  EXPECT_EQ(values_of(cloud, "x"), (Values{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
}

struct Shape {
  std::string header;
  std::size_t width, height;
};

class PcdShapes : public ::testing::TestWithParam<Shape> {};

TEST_P(PcdShapes, FollowFromWhatThereIs) {
  const PointCloud cloud = read_pcd(xyz(GetParam().header, "binary\n" + std::string(72, '\0')));
  EXPECT_EQ(cloud.width, GetParam().width);
  EXPECT_EQ(cloud.height, GetParam().height);
  EXPECT_EQ(cloud.data.size(), cloud.size() * 12);
}

INSTANTIATE_TEST_SUITE_P(Incomplete, PcdShapes,
                         ::testing::Values(Shape{"WIDTH 6\n", 6, 1}, Shape{"POINTS 6\n", 6, 1},
                                           Shape{"WIDTH 3\nHEIGHT 2\n", 3, 2},
                                           Shape{"HEIGHT 2\nPOINTS 6\n", 3, 2},
                                           Shape{"WIDTH 3\nPOINTS 6\n", 3, 2},
                                           Shape{"WIDTH 0\nHEIGHT 1\nPOINTS 0\n", 0, 1},
                                           Shape{"WIDTH 5\nHEIGHT 0\nPOINTS 0\n", 5, 0},
                                           Shape{"POINTS 0\n", 0, 1}));

TEST(PcdShape, MustNotContradictItself) {
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 3\nHEIGHT 2\nPOINTS 5\n", "binary\n")),
                       "line 9: expected as many POINTS as WIDTH times HEIGHT, got 5 instead of 3 "
                       "times 2"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("HEIGHT 2\nPOINTS 5\n", "binary\n")),
                       "got 5 instead of 2 times 2"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("HEIGHT 0\nPOINTS 5\n", "binary\n")),
                       "got 5 instead of 0 times 0"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("HEIGHT 2\n", "binary\n")), "expected a line WIDTH"));
  EXPECT_TRUE(contains(error_in_pcd(xyz("WIDTH 4294967296\nHEIGHT 4294967296\n", "binary\n")),
                       "fewer than 2^64 points, got WIDTH 4294967296 and HEIGHT 4294967296"));
  EXPECT_TRUE(contains(
      error_in_pcd(xyz("WIDTH 4294967296\nHEIGHT 4294967296\nPOINTS 0\n", "binary\n")), "2^64"));
}

TEST(PcdHeader, MakesCoordinatesLowerCase) {
  EXPECT_EQ(names_of(read_pcd(
                "FIELDS X Y Z I\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nDATA ascii\n1 2 3 4")),
            (test::Names{"x", "y", "z", "I"}));
  EXPECT_EQ(names_of(read_pcd(
                "FIELDS X x y z\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nDATA ascii\n1 2 3 4")),
            (test::Names{"X", "x", "y", "z"}));
}

TEST(PcdHeader, MustHaveTheCoordinates) {
  const std::string message =
      error_in_pcd("FIELDS x y depth\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3\n");
  EXPECT_TRUE(contains(message,
                       "expected the fields x, y and z, got no z among the fields 'x', "
                       "'y', 'depth'"));
  EXPECT_TRUE(
      contains(error_in_pcd("FIELDS\nSIZE\nTYPE\nWIDTH 0\nDATA ascii\n"), "among the fields none"));
  EXPECT_TRUE(contains(
      error_in_pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 2\nWIDTH 0\nDATA ascii\n"),
      "expected one z a point, got 2"));
  EXPECT_TRUE(contains(
      error_in_pcd("FIELDS x y z x\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nDATA ascii\n1 2 3 4\n"),
      "expected every field once, got 'x' twice"));
}

struct WrongPcdHeader {
  std::string header;
  std::string message;
};

class PcdWrongHeader : public ::testing::TestWithParam<WrongPcdHeader> {};

TEST_P(PcdWrongHeader, IsNamedWithItsLine) {
  EXPECT_TRUE(contains(error_in_pcd(GetParam().header), GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Pcd, PcdWrongHeader,
    ::testing::Values(
        WrongPcdHeader{"",
                       "line 1: expected a PCD header that ends with the line DATA, got the end"},
        WrongPcdHeader{"VERSION 0.7\nFIELDS x y z\n", "line 3: expected a PCD header"},
        WrongPcdHeader{
            "ply\nformat ascii 1.0\n",
            "line 1: expected a line of a PCD header (VERSION, FIELDS, SIZE, TYPE, COUNT, "
            "WIDTH, HEIGHT, VIEWPOINT, POINTS, DATA), got 'ply'; if the file has another "
            "format, say which with --format"},
        WrongPcdHeader{"\x01\xff\n", "got '\?\?'"},
        WrongPcdHeader{std::string(70000, 'x'),
                       "line 1: expected a header's line of at most 65536 bytes, got a longer one"},
        WrongPcdHeader{"VERSION 1.0\nDATA ascii\n",
                       "line 1: expected VERSION 0.7 or one before it, "
                       "got '1.0'; convert the file"},
        WrongPcdHeader{"VERSION\nDATA ascii\n", "line 1: expected one word after VERSION, got 0"},
        WrongPcdHeader{"WIDTH 1\nDATA ascii\n",
                       "scan: expected a line FIELDS in the header, got none"},
        WrongPcdHeader{"FIELDS x y z\nDATA ascii\n", "expected a line SIZE"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nDATA ascii\n", "expected a line TYPE"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4\nTYPE F F F\nDATA ascii\n",
                       "line 2: expected 3 words after SIZE, one for each of FIELDS, got 2"},
        WrongPcdHeader{
            "FIELDS x y z\nSIZE 4 4 2\nTYPE F F F\nDATA ascii\n",
            "line 3: expected I or U of SIZE 1, 2, 4 or 8, or F of SIZE 4 or 8, got TYPE "
            "'F' of SIZE '2' for 'z'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 -4\nTYPE F F F\nDATA ascii\n", "SIZE '-4' for 'z'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F B\nDATA ascii\n",
                       "TYPE 'B' of SIZE '4'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 0\nDATA ascii\n",
                       "line 4: expected a COUNT from 1 to 4294967295, got '0' for 'z'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 18446744073709551615\n"
                       "DATA ascii\n",
                       "got '18446744073709551615' for 'z'"},
        WrongPcdHeader{"WIDTH 1\nWIDTH 2\n", "line 2: expected one line WIDTH, got a second one"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH -1\nDATA ascii\n",
                       "line 4: expected a whole number after WIDTH, got '-1'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH many\nDATA ascii\n",
                       "got 'many'"},
        WrongPcdHeader{
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 18446744073709551616\nDATA ascii\n",
            "got '18446744073709551616'"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nVIEWPOINT 1 2\nDATA ascii\n",
                       "line 5: expected seven numbers after VIEWPOINT"},
        WrongPcdHeader{"FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nDATA zipped\n",
                       "line 5: expected DATA ascii, binary or binary_compressed, got 'zipped'"}));

TEST(PcdFile, IsNoDirectory) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(
      contains(test::error_of(folder.path(), ScanFormat::pcd), "expected a file, got a directory"));
}

using RealPcd = test::WithSharedData;

TEST_F(RealPcd, OfKittiIsWhole) {
  PointCloud cloud;
  read_scan(data() / "pcd/kitti_city_data_1_0000000000.pcd", ScanFormat::pcd, cloud);
  EXPECT_EQ(cloud.size(), 119978U);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "intensity"}));
  expect_values_between(cloud, "x", -80, 80);
  expect_values_between(cloud, "intensity", 0, 1);
  read_scan(data() / "pcd/kitti_city_data_2_0000000000.pcd", ScanFormat::pcd, cloud);
  EXPECT_EQ(cloud.size(), 123398U);
  expect_values_between(cloud, "z", -10, 5);
}

TEST_F(RealPcd, OfOneHundredAndTwentyEightBeamsIsWhole) {
  PointCloud cloud;
  read_scan(data() / "pcd/patchwork_128beam_binary_compressed.pcd", ScanFormat::pcd, cloud);
  EXPECT_EQ(cloud.width, 1875U);
  EXPECT_EQ(cloud.height, 128U);
  EXPECT_EQ(cloud.stride_bytes, 27U);
  EXPECT_EQ(names_of(cloud),
            (test::Names{"x", "y", "z", "timestamp", "intensity", "ring", "azimuth"}));
  EXPECT_EQ(cloud.find("timestamp")->type, FieldType::float64);
  expect_values_between(cloud, "x", -300, 300);
  expect_values_between(cloud, "ring", 0, 127);
  expect_values_between(cloud, "azimuth", 0, 360);
}

using OversizedPcd = test::OversizedFile;

TEST_F(OversizedPcd, IsNamed) {
  test::write_file(folder / "huge.pcd", xyz("WIDTH 1400000000\n", "binary\n"));
  std::filesystem::resize_file(folder / "huge.pcd", kBytes + 1000);
  EXPECT_TRUE(contains(test::error_of(folder / "huge.pcd", ScanFormat::pcd),
                       "huge.pcd: expected a file that fits into memory"));
}

}  // namespace
}  // namespace groundgrid::io
