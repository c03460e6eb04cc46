// PCD files with DATA binary_compressed.
#include <gtest/gtest.h>

#include "io/pcd.hpp"
#include "pcd_content.hpp"

namespace groundgrid::io {
namespace {

using test::bytes_of;
using test::contains;
using test::error_in_pcd;
using test::names_of;
using test::read_pcd;
using test::values_of;
using namespace std::string_literals;

using Values = std::vector<double>;

// Three points of one byte a field. 'abc' is itself as LZF: a run of three letters.
constexpr const char* kBytes =
    "FIELDS x y z\nSIZE 1 1 1\nTYPE U U U\nWIDTH 3\nDATA binary_compressed\n";

TEST(PcdCompressed, LiesFieldByField) {
  // Nine letters as they are: 0x08 says that nine follow.
  const PointCloud cloud = read_pcd(kBytes + bytes_of(10) + bytes_of(9) + "\x08" + "abcdefghi");
  EXPECT_EQ(cloud.encoding, CloudEncoding::binary_compressed);
  EXPECT_EQ(values_of(cloud, "x"), (Values{'a', 'b', 'c'}));
  EXPECT_EQ(values_of(cloud, "y"), (Values{'d', 'e', 'f'}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{'g', 'h', 'i'}));
}

TEST(PcdCompressed, RefersToWhatWasBefore) {
  // One letter, then a reference of 6 + 2 letters to one place before.
  const PointCloud cloud = read_pcd(kBytes + bytes_of(4) + bytes_of(9) + "\x00x\xc0\x00"s);
  for (const char* const name : {"x", "y", "z"})
    EXPECT_EQ(values_of(cloud, name), (Values{'x', 'x', 'x'}));
}

TEST(PcdCompressed, MayHaveFieldsOfEveryWidthAndPadding) {
  const std::string header =
      "FIELDS x _ y z h\nSIZE 4 1 8 2 1\nTYPE F U F I U\nCOUNT 1 3 1 1 3\nWIDTH 2\nDATA "
      "binary_compressed\n";
  const double y0 = 0.5, y1 = -0.5;
  std::string planes = bytes_of({1, 2}) + "ppp" + "ppp";
  planes.append(reinterpret_cast<const char*>(&y0), 8)
      .append(reinterpret_cast<const char*>(&y1), 8);
  planes += "\x01\x00\xff\xff"s + "abc" + "def";
  ASSERT_EQ(planes.size(), 40U);
  // Runs of at most 32 letters.
  const std::string packed = "\x1f" + planes.substr(0, 32) + "\x07" + planes.substr(32);
  const PointCloud cloud = read_pcd(header + bytes_of(42) + bytes_of(40) + packed);
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z", "h"}));
  EXPECT_EQ(values_of(cloud, "x"), (Values{1.0, 2.0}));
  EXPECT_EQ(values_of(cloud, "y"), (Values{0.5, -0.5}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{1.0, -1.0}));
  EXPECT_EQ(values_of(cloud, "h"), (Values{'a', 'd'}));
}

TEST(PcdCompressed, MayHoldNoPoints) {
  const std::string header =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nDATA binary_compressed\n";
  // With the two sizes of nothing, without them, and with more.
  EXPECT_EQ(read_pcd(header).size(), 0U);
  EXPECT_EQ(read_pcd(header).surplus_bytes, 0U);
  EXPECT_EQ(read_pcd(header + bytes_of(0) + bytes_of(0)).size(), 0U);
  EXPECT_EQ(read_pcd(header + bytes_of(0) + bytes_of(0)).surplus_bytes, 0U);
  EXPECT_EQ(read_pcd(header + bytes_of(0) + bytes_of(0) + "abc").surplus_bytes, 3U);
}

TEST(PcdCompressed, CountsTheBytesAfterTheLastPoint) {
  const std::string content = kBytes + bytes_of(10) + bytes_of(9) + "\x08" + "abcdefghi";
  EXPECT_EQ(read_pcd(content).surplus_bytes, 0U);
  const PointCloud cloud = read_pcd(content + "jk");
  EXPECT_EQ(cloud.surplus_bytes, 2U);
  EXPECT_EQ(values_of(cloud, "z"), (Values{'g', 'h', 'i'}));
}

TEST(PcdCompressed, MustBeOfTheSizesItSays) {
  const std::string header = kBytes;
  const std::string place = "scan, byte " + std::to_string(header.size()) + ": ";
  EXPECT_TRUE(contains(error_in_pcd(header + "1234"),
                       place + "expected 8 bytes with the sizes of the compressed points, got 4"));
  EXPECT_TRUE(contains(error_in_pcd(header + bytes_of(11) + bytes_of(9) + "\x08" + "abcdefghi"),
                       place + "expected 11 bytes of compressed points, got 10 bytes"));
  EXPECT_TRUE(
      contains(error_in_pcd(header + bytes_of(10) + bytes_of(8) + "\x08" + "abcdefghi"),
               place + "expected 3 points of 3 bytes, as the header promises, got 8 bytes"));
  EXPECT_TRUE(
      contains(error_in_pcd(header + bytes_of(0) + bytes_of(9)), "which cannot give so many"));
  EXPECT_TRUE(contains(error_in_pcd("FIELDS x y z\nSIZE 1 1 1\nTYPE U U U\nWIDTH 1000000000\nDATA "
                                    "binary_compressed\n" +
                                    bytes_of(10) + bytes_of(3000000000) + "\x08" + "abcdefghi"),
                       "got 10 bytes, which cannot give so many"));
}

TEST(PcdCompressed, MustGiveWhatItSays) {
  const std::string header = kBytes;
  const std::string place = "scan, byte " + std::to_string(header.size() + 8) + ": ";
  EXPECT_TRUE(contains(error_in_pcd(header + bytes_of(9) + bytes_of(9) + "\x07" + "abcdefgh"),
                       place + "expected compressed points that give 9 bytes, got 8"));
  EXPECT_TRUE(contains(error_in_pcd(header + bytes_of(11) + bytes_of(9) + "\x09" + "abcdefghij"),
                       place +
                           "expected compressed points that give 9 bytes, got bytes that are no "
                           "LZF data or give more"));
  // A reference to before the beginning.
  EXPECT_TRUE(
      contains(error_in_pcd(header + bytes_of(3) + bytes_of(9) + "\xe0\x00\x10"s), "no LZF data"));
}

}  // namespace
}  // namespace groundgrid::io
