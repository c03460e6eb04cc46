#include "io/ply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloud_checks.hpp"
#include "io/error.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::names_of;
using test::values_of;
using namespace std::string_literals;

using Values = std::vector<double>;

PointCloud read(std::string_view content) { return test::read_content(content, ScanFormat::ply); }

std::string error(std::string_view content) { return test::error_in(content, ScanFormat::ply); }

template <typename Number>
std::string little(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

template <typename Number>
std::string big(Number number) {
  std::string bytes = little(number);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

constexpr const char* kXyz = "property float x\nproperty float y\nproperty float z\n";

TEST(PlyAscii, IsReadWithEveryTypeInBothSpellings) {
  const std::vector<std::pair<std::string, FieldType>> types{
      {"char", FieldType::int8},      {"int8", FieldType::int8},
      {"uchar", FieldType::uint8},    {"uint8", FieldType::uint8},
      {"short", FieldType::int16},    {"int16", FieldType::int16},
      {"ushort", FieldType::uint16},  {"uint16", FieldType::uint16},
      {"int", FieldType::int32},      {"int32", FieldType::int32},
      {"uint", FieldType::uint32},    {"uint32", FieldType::uint32},
      {"float", FieldType::float32},  {"float32", FieldType::float32},
      {"double", FieldType::float64}, {"float64", FieldType::float64}};
  std::string header = "ply\nformat ascii 1.0\nelement vertex 1\n"s + kXyz;
  std::string line = "1 2 3";
  for (std::size_t i = 0; i < types.size(); ++i) {
    header += "property " + types[i].first + " p" + std::to_string(i) + "\n";
    line.append(" ").append(std::to_string(i + 100));
  }
  const PointCloud cloud = read(header + "end_header\n" + line + "\n");
  ASSERT_EQ(cloud.fields.size(), 3 + types.size());
  EXPECT_EQ(cloud.encoding, CloudEncoding::ascii);
  for (std::size_t i = 0; i < types.size(); ++i) {
    EXPECT_EQ(cloud.fields[i + 3].type, types[i].second) << types[i].first;
    EXPECT_EQ(value_at(cloud, 0, cloud.fields[i + 3]), static_cast<double>(i + 100));
  }
}

TEST(PlyAscii, TakesCommentsLineEndsAndOtherElementsAsTheyCome) {
  const PointCloud cloud = read(
      "ply\r\nformat ascii 1.0\r\ncomment element vertex 7\r\nobj_info by hand\r\n"
      "element camera 1\r\nproperty float a\r\nelement nothing 1000000000000\r\n"
      "element face 2\r\nproperty list uchar int vertex_indices\r\n"
      "element vertex 2\r\nproperty double X\r\nproperty double Y\r\nproperty double Z\r\n"
      "element edge 1\r\nproperty int from\r\nend_header\r\n"
      "0.5\r\n3 0 1 2\r\n\r\n0\r\n1 2 3\r\nnan -inf 6.5\r\nthe rest does not matter\r\n");
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z"}));
  EXPECT_EQ(cloud.find("x")->type, FieldType::float64);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(values_of(cloud, "x")[0], 1.0);
  EXPECT_TRUE(std::isnan(values_of(cloud, "x")[1]));
  EXPECT_EQ(values_of(cloud, "y")[1], -HUGE_VAL);
  EXPECT_EQ(values_of(cloud, "z"), (Values{3.0, 6.5}));
}

TEST(PlyAscii, HoldsWhatTheHeaderPromises) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\n"s + kXyz + "end_header\n";
  EXPECT_TRUE(contains(error(header + "1.000 2.000 3.000\n4 5 6\n"),
                       "line 9: expected 3 points, as the header promises, got the end of the file "
                       "after 2"));
  EXPECT_TRUE(contains(error(header + "1 2 3\n4 five 6\n7 8 9\n"),
                       "line 9: expected a float32 for 'y', got 'five'"));
  EXPECT_TRUE(contains(error("ply\nformat ascii 1.0\nelement a 5\nproperty int b\n"
                             "element vertex 0\n"s +
                             kXyz + "end_header\n1\n2\n"),
                       "line 11: expected 5 lines of an element before the points, got the end of "
                       "the file after 2"));
}

TEST(PlyBinary, IsReadInBothByteOrders) {
  const std::string header =
      "property double x\nproperty float y\nproperty short z\n"
      "property uchar ring\nproperty uint time\nend_header\n";
  const PointCloud cloud = read(
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\n" + header + little(1.5) +
      little(-2.5F) + little<std::int16_t>(-3) + "\x07" + little<std::uint32_t>(4000000000) +
      little(0.1) + little(0.1F) + little<std::int16_t>(258) + "\xff" + little<std::uint32_t>(1));
  const PointCloud swapped =
      read("ply\nformat binary_big_endian 1.0\nelement vertex 2\n" + header + big(1.5) +
           big(-2.5F) + big<std::int16_t>(-3) + "\x07" + big<std::uint32_t>(4000000000) + big(0.1) +
           big(0.1F) + big<std::int16_t>(258) + "\xff" + big<std::uint32_t>(1));
  EXPECT_EQ(cloud.encoding, CloudEncoding::binary);
  EXPECT_EQ(swapped.encoding, CloudEncoding::binary_big_endian);
  EXPECT_EQ(cloud.data, swapped.data);
  EXPECT_EQ(values_of(cloud, "x"), (Values{1.5, 0.1}));
  EXPECT_EQ(values_of(cloud, "y"), (Values{-2.5, static_cast<double>(0.1F)}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{-3.0, 258.0}));
  EXPECT_EQ(values_of(cloud, "ring"), (Values{7.0, 255.0}));
  EXPECT_EQ(values_of(cloud, "time"), (Values{4000000000.0, 1.0}));
}

TEST(PlyBinary, SkipsOtherElementsBeforeThePoints) {
  const std::string header =
      "element camera 2\nproperty double a\nproperty char b\nelement nothing 1000000000000\n"
      "element face 2\nproperty int flags\nproperty list uchar ushort v\n"
      "property list int double t\nelement vertex 1\n"s +
      kXyz + "end_header\n";
  const std::string camera(18, 'c');
  const PointCloud cloud =
      read("ply\nformat binary_little_endian 1.0\n" + header + camera + little(1) + "\x02" +
           "abcd" + little(0) + little(2) + "\x00"s + little(1) + "12345678" + little(1.0F) +
           little(2.0F) + little(3.0F));
  EXPECT_EQ(values_of(cloud, "x"), Values{1.0});
  EXPECT_EQ(values_of(cloud, "z"), Values{3.0});
  const PointCloud swapped =
      read("ply\nformat binary_big_endian 1.0\n" + header + camera + big(1) + "\x02" + "abcd" +
           big(0) + big(2) + "\x00"s + big(1) + "12345678" + big(1.0F) + big(2.0F) + big(3.0F));
  EXPECT_EQ(swapped.data, cloud.data);
}

TEST(PlyBinary, CountsTheBytesAfterTheLastRecord) {
  const std::string begin =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\n"s + kXyz + "element nothing 5\n";
  const std::string points = big(1.0F) + big(2.0F) + big(3.0F);
  EXPECT_EQ(read(begin + "end_header\n" + points).surplus_bytes, 0U);
  const PointCloud cloud = read(begin + "end_header\n" + points + "abcde");
  EXPECT_EQ(cloud.surplus_bytes, 5U);
  EXPECT_EQ(values_of(cloud, "z"), Values{3.0});
  // Faces belong there, and are not read.
  const std::string face = "element face 1\nproperty uchar a\n";
  EXPECT_EQ(read(begin + face + "end_header\n" + points + "abcde").surplus_bytes, 0U);
  const std::string no_face = "element face 0\nproperty uchar a\n";
  EXPECT_EQ(read(begin + no_face + "end_header\n" + points + "abcde").surplus_bytes, 5U);
}

TEST(PlyBinary, HoldsWhatTheHeaderPromises) {
  const std::string begin = "ply\nformat binary_little_endian 1.0\n";
  EXPECT_TRUE(
      contains(error(begin + "element vertex 3\n" + kXyz + "end_header\n" + "12345678901234"),
               ": expected 3 points of 12 bytes, as the header promises, got 14 bytes, which "
               "hold 1"));
  EXPECT_TRUE(
      contains(error(begin + "element vertex 18446744073709551615\n" + kXyz + "end_header\n"),
               "got 0 bytes"));
  const std::string vertex = "element vertex 0\n"s + kXyz + "end_header\n";
  const std::string message =
      "whole records of the element 'face', got the end of the file among them";
  EXPECT_TRUE(contains(error(begin + "element face 9\nproperty int a\n" + vertex + "1234"),
                       "expected 9 " + message));
  EXPECT_TRUE(contains(
      error(begin + "element face 18446744073709551615\nproperty double a\n" + vertex), message));
  const std::string list = "element face 1000000000000000\nproperty list int double a\n" + vertex;
  EXPECT_TRUE(contains(error(begin + list), message));
  EXPECT_TRUE(contains(error(begin + list + little(2) + "12345678"), message));
  EXPECT_TRUE(contains(error(begin + list + little(-1) + std::string(99, '\0')), message));
  EXPECT_TRUE(contains(error(begin + list + little(0x7FFFFFFF) + "123"), message));
  EXPECT_TRUE(contains(error(begin + "element face 1\nproperty list float char a\n" + vertex +
                             little(std::nanf("")) + "123"),
                       message));
}

TEST(PlyFile, MayHoldNoPoints) {
  const std::string rest = " 1.0\nelement vertex 0\n"s + kXyz + "end_header\n";
  for (const char* const format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const PointCloud cloud = read("ply\nformat "s + format + rest);
    EXPECT_EQ(cloud.size(), 0U) << format;
    EXPECT_EQ(cloud.fields.size(), 3U) << format;
  }
}

// Lists before, between and behind the coordinates.
const std::string kVertexWithLists =
    "element vertex 2\nproperty list uchar int a\nproperty float x\nproperty float y\n"
    "property list ushort double b\nproperty list int uchar c\nproperty float z\n"
    "property list uchar uchar d\nend_header\n";

void expect_two_points(const PointCloud& cloud) {
  EXPECT_EQ(names_of(cloud), (test::Names{"x", "y", "z"}));
  EXPECT_EQ(values_of(cloud, "x"), (Values{1, 4}));
  EXPECT_EQ(values_of(cloud, "y"), (Values{2, 5}));
  EXPECT_EQ(values_of(cloud, "z"), (Values{3, 6}));
  EXPECT_EQ(cloud.surplus_bytes, 0U);
}

TEST(PlyAscii, PassesOverListsInItsVertices) {
  const std::string begin = "ply\nformat ascii 1.0\n" + kVertexWithLists;
  expect_two_points(read(begin + "2 7 8 1 2 0 1 9 3 0\n0 4 5 1 7.5 0 6 3 1 2 3\n"));
  EXPECT_TRUE(contains(error(begin + "2 7 8 1 2 0 1 9 3 0\n-1 4 5 1 7.5 0 6 0\n"),
                       "line 13: expected the count of a list and so many numbers, got '-1'"));
  EXPECT_TRUE(contains(error(begin + "9 7 8 1 2 0 1 9 3 0\n0 4 5 0 0 6 0\n"), "line 12"));
  EXPECT_TRUE(contains(error(begin + "999 7 8 1 2 0 1 9 3 0\n0 4 5 0 0 6 0\n"), "got '999'"));
  EXPECT_TRUE(contains(
      error(begin + "0 1 2 0 0 3 4 1 2 3\n0 4 5 0 0 6 0\n"),
      "line 12: expected the count of a list and so many numbers, got the end of the line"));
  EXPECT_TRUE(contains(error(begin + "0 1 2 0 0 3 1 1 2 3\n0 4 5 0 0 6 0\n"), "got more: '2'"));
}

template <typename Bytes>
std::string two_points_with_lists(Bytes bytes) {
  const auto byte = [](char value) { return std::string(1, value); };
  return byte(2) + bytes(7) + bytes(8) + bytes(1.0F) + bytes(2.0F) + bytes(std::uint16_t{0}) +
         bytes(1) + byte(9) + bytes(3.0F) + byte(0) + byte(0) + bytes(4.0F) + bytes(5.0F) +
         bytes(std::uint16_t{1}) + bytes(7.5) + bytes(0) + bytes(6.0F) + byte(3) + "123";
}

TEST(PlyBinary, PassesOverListsInItsVertices) {
  const std::string numbers = two_points_with_lists([](auto number) { return little(number); });
  const std::string begin = "ply\nformat binary_little_endian 1.0\n" + kVertexWithLists;
  expect_two_points(read(begin + numbers));
  expect_two_points(read("ply\nformat binary_big_endian 1.0\n" + kVertexWithLists +
                         two_points_with_lists([](auto number) { return big(number); })));
  for (std::size_t left = 0; left < numbers.size(); ++left)
    EXPECT_TRUE(contains(error(begin + numbers.substr(0, left)), "expected ")) << left;
}

struct WrongPlyHeader {
  std::string header;
  std::string message;
};

class PlyWrongHeader : public ::testing::TestWithParam<WrongPlyHeader> {};

TEST_P(PlyWrongHeader, IsNamedWithItsLine) {
  EXPECT_TRUE(contains(error(GetParam().header), GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Ply, PlyWrongHeader,
    ::testing::Values(
        WrongPlyHeader{"",
                       "line 1: expected a PLY header that ends with the line end_header, got the "
                       "end of the file"},
        WrongPlyHeader{"ply\nformat ascii 1.0\n", "line 3: expected a PLY header that ends"},
        WrongPlyHeader{"# .PCD v0.7\n",
                       "line 1: expected the word 'ply' alone in the first line, got "
                       "'# .PCD v0.7'; if the file has another format, say which "
                       "with --format"},
        WrongPlyHeader{"ply" + std::string(70000, 'x'),
                       "line 1: expected a header's line of at most"},
        WrongPlyHeader{"ply\nend_header\n",
                       "line 2: expected a line 'format' in the header, got none"},
        WrongPlyHeader{"ply\nformat ascii 1.0\nformat ascii 1.0\n",
                       "line 3: expected one line 'format', got a second one"},
        WrongPlyHeader{
            "ply\nformat ascii 2.0\n",
            "line 2: expected format ascii, binary_little_endian or binary_big_endian 1.0, "
            "got 'format ascii 2.0'"},
        WrongPlyHeader{"ply\nformat\n", "line 2: expected format ascii"},
        WrongPlyHeader{"ply\nvertex 3\n",
                       "line 2: expected a line of a PLY header (format, element, "
                       "property, comment, obj_info, end_header), got 'vertex'"},
        WrongPlyHeader{
            "ply\nelement vertex -3\n",
            "line 2: expected 'element', a name and a whole number, got 'element vertex -3'"},
        WrongPlyHeader{"ply\nelement vertex 18446744073709551616\n", "line 2: expected 'element'"},
        WrongPlyHeader{"ply\nelement vertex\n", "line 2: expected 'element'"},
        WrongPlyHeader{"ply\nproperty float x\n",
                       "line 2: expected an element before its properties, got 'property float x'"},
        WrongPlyHeader{
            "ply\nelement vertex 1\nproperty half x\n",
            "line 3: expected a type of PLY (char, uchar, short, ushort, int, uint, float, "
            "double, or int8 to float64), got 'half'"},
        WrongPlyHeader{
            "ply\nelement vertex 1\nproperty list uchar x\n",
            "line 3: expected 'property', a type and a name, or 'property list', two types "
            "and a name"},
        WrongPlyHeader{"ply\nelement vertex 1\nproperty\n", "line 3: expected 'property'"},
        WrongPlyHeader{"ply\nformat ascii 1.0\nend_header\n",
                       "expected an element 'vertex' in the header, got no element"},
        WrongPlyHeader{"ply\nformat ascii 1.0\nelement point 1\nproperty float x\nend_header\n1\n",
                       "got the elements 'point'"},
        WrongPlyHeader{"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                       "y\nend_header\n1 2\n",
                       "expected the fields x, y and z, got no z among the fields 'x', 'y'"},
        WrongPlyHeader{"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                       "x\nend_header\n1 2\n",
                       "expected every field once, got 'x' twice"}));

}  // namespace
}  // namespace groundgrid::io
