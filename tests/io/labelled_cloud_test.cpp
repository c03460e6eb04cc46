#include "io/labelled_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "cloud_checks.hpp"
#include "io/error.hpp"
#include "shared_data.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;
using test::names_of;
using test::values_of;
using namespace std::string_literals;

using Values = std::vector<double>;

template <typename Number>
void set(PointCloud& cloud, std::size_t point, std::string_view name, Number number,
         std::size_t i = 0) {
  const PointField& field = *cloud.find(name);
  ASSERT_EQ(sizeof number, size_of(field.type)) << name;
  std::memcpy(cloud.data.data() + point * cloud.stride_bytes + field.offset + i * sizeof number,
              &number, sizeof number);
}

// Two rows of two points with a field of every type and numbers that are hard to write.
PointCloud every_type(CloudEncoding encoding) {
  PointCloud cloud;
  cloud.encoding = encoding;
  cloud.viewpoint = "1 2 3 1 0 0 0";
  cloud.add_field("a", FieldType::int8);
  cloud.add_field("x", FieldType::float32);
  cloud.add_field("b", FieldType::uint8);
  cloud.add_field("y", FieldType::float64);
  cloud.add_field("c", FieldType::int16);
  cloud.add_field("d", FieldType::uint16);
  cloud.add_field("z", FieldType::float32);
  cloud.add_field("e", FieldType::int32);
  cloud.add_field("f", FieldType::uint32);
  cloud.add_field("g", FieldType::int64);
  cloud.add_field("h", FieldType::uint64);
  cloud.add_field("hist", FieldType::float32, 2);
  cloud.width = 2;
  cloud.height = 2;
  cloud.data.resize(cloud.size() * cloud.stride_bytes);
  const float floats[] = {0.1F, -0.0F, std::numeric_limits<float>::denorm_min(),
                          std::numeric_limits<float>::max()};
  const double doubles[] = {0.1, 1.0 / 3.0, std::numeric_limits<double>::denorm_min(), -1e300};
  for (std::size_t i = 0; i < 4; ++i) {
    set(cloud, i, "a", static_cast<std::int8_t>(i == 0 ? -128 : 48));
    set(cloud, i, "x", floats[i]);
    set(cloud, i, "b", static_cast<std::uint8_t>(i == 0 ? 255 : 65));
    set(cloud, i, "y", doubles[i]);
    set(cloud, i, "c", std::numeric_limits<std::int16_t>::min());
    set(cloud, i, "d", std::numeric_limits<std::uint16_t>::max());
    set(cloud, i, "z", std::numeric_limits<float>::quiet_NaN());
    set(cloud, i, "e", std::numeric_limits<std::int32_t>::min());
    set(cloud, i, "f", std::numeric_limits<std::uint32_t>::max());
    set(cloud, i, "g", std::numeric_limits<std::int64_t>::min());
    set(cloud, i, "h", std::numeric_limits<std::uint64_t>::max() - i);
    set(cloud, i, "hist", static_cast<float>(i) + 0.25F);
    set(cloud, i, "hist", -std::numeric_limits<float>::infinity(), 1);
  }
  return cloud;
}

const std::vector<std::uint32_t> kLabels{40, 99, 1, 0};
const std::vector<float> kHeights{0.02F, 1.5F, -3.25F, std::numeric_limits<float>::quiet_NaN()};

PointCloud written(const PointCloud& cloud, ScanFormat format) {
  const test::TemporaryFolder folder;
  write_labelled_cloud(folder / "out", format, cloud, kLabels, kHeights);
  PointCloud result;
  read_scan(folder / "out", format, result);
  return result;
}

// Every field of a cloud is in another one too, bit for bit.
void expect_fields_kept(const PointCloud& cloud, const PointCloud& result) {
  ASSERT_EQ(result.size(), cloud.size());
  for (const PointField& field : cloud.fields) {
    const PointField* const other = result.find(field.name);
    ASSERT_NE(other, nullptr) << field.name;
    ASSERT_EQ(other->type, field.type) << field.name;
    ASSERT_EQ(other->count, field.count) << field.name;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      ASSERT_EQ(
          std::memcmp(cloud.data.data() + i * cloud.stride_bytes + field.offset,
                      result.data.data() + i * result.stride_bytes + other->offset, field.bytes()),
          0)
          << field.name << " of point " << i;
  }
}

void expect_answers(const PointCloud& result) {
  ASSERT_GE(result.fields.size(), 2U);
  const PointField& label = result.fields[result.fields.size() - 2];
  const PointField& height = result.fields.back();
  EXPECT_EQ(label.name, "label");
  EXPECT_EQ(label.type, FieldType::uint32);
  EXPECT_EQ(height.name, "height_above_ground");
  EXPECT_EQ(height.type, FieldType::float32);
  EXPECT_EQ(values_of(result, "label"), (Values{40, 99, 1, 0}));
  const Values heights = values_of(result, "height_above_ground");
  EXPECT_EQ(heights[0], static_cast<double>(0.02F));
  EXPECT_EQ(heights[2], -3.25);
  EXPECT_TRUE(std::isnan(heights[3]));
}

class LabelledPcd : public ::testing::TestWithParam<CloudEncoding> {};

TEST_P(LabelledPcd, KeepsEveryFieldBitForBit) {
  const PointCloud cloud = every_type(GetParam());
  const PointCloud result = written(cloud, ScanFormat::pcd);
  expect_fields_kept(cloud, result);
  expect_answers(result);
  EXPECT_EQ(result.fields.size(), cloud.fields.size() + 2);
  EXPECT_EQ(result.width, 2U);
  EXPECT_EQ(result.height, 2U);
  EXPECT_EQ(result.viewpoint, "1 2 3 1 0 0 0");
  EXPECT_EQ(result.encoding, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Encodings, LabelledPcd,
                         ::testing::Values(CloudEncoding::ascii, CloudEncoding::binary,
                                           CloudEncoding::binary_compressed));

class LabelledPly : public ::testing::TestWithParam<CloudEncoding> {};

TEST_P(LabelledPly, KeepsEveryFieldThatPlyHas) {
  PointCloud cloud = every_type(GetParam());
  for (std::size_t i = 0; i < 4; ++i) set(cloud, i, "h", std::uint64_t{9007199254740991});
  const PointCloud result = written(cloud, ScanFormat::ply);
  expect_answers(result);
  EXPECT_EQ(result.encoding, GetParam());
  EXPECT_EQ(names_of(result), (test::Names{"a", "x", "b", "y", "c", "d", "z", "e", "f", "g", "h",
                                           "hist_0", "hist_1", "label", "height_above_ground"}));
  EXPECT_EQ(values_of(result, "hist_0"), (Values{0.25, 1.25, 2.25, 3.25}));
  EXPECT_EQ(result.find("h")->type, FieldType::float64);
  EXPECT_EQ(values_of(result, "g")[0], -0x1p63);
  EXPECT_EQ(values_of(result, "h")[0], 9007199254740991.0);
  std::erase_if(cloud.fields, [](const PointField& field) {
    return field.name == "g" || field.name == "h" || field.name == "hist";
  });
  expect_fields_kept(cloud, result);
}

INSTANTIATE_TEST_SUITE_P(Encodings, LabelledPly,
                         ::testing::Values(CloudEncoding::ascii, CloudEncoding::binary,
                                           CloudEncoding::binary_big_endian));

TEST(LabelledCloud, IsBinaryWhereTheFormatHasNoSuchEncoding) {
  EXPECT_EQ(written(every_type(CloudEncoding::binary_big_endian), ScanFormat::pcd).encoding,
            CloudEncoding::binary);
  EXPECT_EQ(written(every_type(CloudEncoding::binary_compressed), ScanFormat::ply).encoding,
            CloudEncoding::binary);
}

TEST(LabelledCloud, IsBinaryWhereItCannotBeCompressed) {
  PointCloud cloud;
  for (const char* const name : {"x", "y", "z"}) cloud.add_field(name, FieldType::uint8);
  cloud.encoding = CloudEncoding::binary_compressed;
  cloud.width = 4;
  cloud.data.resize(12);
  for (std::size_t i = 0; i < 12; ++i) cloud.data[i] = static_cast<std::byte>(i * 37);
  const PointCloud result = written(cloud, ScanFormat::pcd);
  EXPECT_EQ(result.encoding, CloudEncoding::binary);
  expect_fields_kept(cloud, result);
}

TEST(LabelledCloud, IsWrittenAsItsFormatSays) {
  const test::TemporaryFolder folder;
  const PointCloud cloud = test::read_content(
      "FIELDS x y z t\nSIZE 4 8 4 8\nTYPE F F F U\nWIDTH 2\nHEIGHT 2\nDATA ascii\n"
      "0.1 1 -2.5 7\n1 2 3 8\n1 2 3 9\nnan 2 1e30 10\n",
      ScanFormat::pcd);
  write_labelled_cloud(folder / "a.pcd", ScanFormat::pcd, cloud, kLabels, kHeights);
  EXPECT_EQ(test::read_file(folder / "a.pcd"),
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
            "FIELDS x y z t label height_above_ground\nSIZE 4 8 4 8 4 4\nTYPE F F F U U F\n"
            "COUNT 1 1 1 1 1 1\nWIDTH 2\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n"
            "0.1 1 -2.5 7 40 0.02\n1 2 3 8 99 1.5\n1 2 3 9 1 -3.25\nnan 2 1e+30 10 0 nan\n");
  write_labelled_cloud(folder / "a.ply", ScanFormat::ply, cloud, kLabels, kHeights);
  EXPECT_EQ(test::read_file(folder / "a.ply"),
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty double y\n"
            "property float z\nproperty double t\nproperty uint label\n"
            "property float height_above_ground\nend_header\n"
            "0.1 1 -2.5 7 40 0.02\n1 2 3 8 99 1.5\n1 2 3 9 1 -3.25\nnan 2 1e+30 10 0 nan\n");
}

TEST(LabelledCloud, ReplacesLabelsThatWereThere) {
  PointCloud cloud = test::read_content(
      "FIELDS label x height_above_ground y z\nSIZE 2 4 8 4 4\nTYPE I F F F F\nWIDTH 4\n"
      "DATA ascii\n7 1 7 2 3\n7 4 7 5 6\n7 7 7 8 9\n7 10 7 11 12\n",
      ScanFormat::pcd);
  const PointCloud result = written(cloud, ScanFormat::pcd);
  EXPECT_EQ(names_of(result), (test::Names{"x", "y", "z", "label", "height_above_ground"}));
  EXPECT_EQ(values_of(result, "y"), (Values{2, 5, 8, 11}));
  expect_answers(result);
}

TEST(LabelledCloud, OfAKittiScanIsBinary) {
  const PointCloud cloud = test::read_content(std::string(64, '\0'), ScanFormat::kitti);
  const PointCloud result = written(cloud, ScanFormat::pcd);
  EXPECT_EQ(result.encoding, CloudEncoding::binary);
  EXPECT_EQ(names_of(result),
            (test::Names{"x", "y", "z", "intensity", "label", "height_above_ground"}));
}

TEST(LabelledCloud, MayBeEmpty) {
  const test::TemporaryFolder folder;
  for (const CloudEncoding encoding :
       {CloudEncoding::ascii, CloudEncoding::binary, CloudEncoding::binary_compressed})
    for (const ScanFormat format : {ScanFormat::pcd, ScanFormat::ply}) {
      PointCloud cloud = test::read_content("", ScanFormat::kitti);
      cloud.encoding = encoding;
      write_labelled_cloud(folder / "empty", format, cloud, {}, {});
      read_scan(folder / "empty", format, cloud);
      EXPECT_EQ(cloud.size(), 0U);
      EXPECT_EQ(cloud.fields.size(), 6U);
    }
}

TEST(LabelledCloud, GivesEveryNumberOfAHistogramANameOfItsOwn) {
  PointCloud cloud = test::read_content(
      "FIELDS x y z h h_0\nSIZE 4 4 4 1 1\nTYPE F F F U U\nCOUNT 1 1 1 2 1\nWIDTH 4\nDATA ascii\n"
      "1 2 3 4 5 6\n1 2 3 4 5 6\n1 2 3 4 5 6\n1 2 3 4 5 6\n",
      ScanFormat::pcd);
  const PointCloud result = written(cloud, ScanFormat::ply);
  EXPECT_EQ(values_of(result, "h_0_")[0], 4.0);
  EXPECT_EQ(values_of(result, "h_1")[0], 5.0);
  EXPECT_EQ(values_of(result, "h_0")[0], 6.0);
}

// x, y, z and the two answers besides.
PointCloud with_histogram(std::size_t numbers) {
  PointCloud cloud;
  for (const char* const name : {"x", "y", "z"}) cloud.add_field(name, FieldType::float32);
  cloud.add_field("h", FieldType::uint8, numbers);
  cloud.width = kLabels.size();
  cloud.data.resize(cloud.size() * cloud.stride_bytes);
  return cloud;
}

TEST(LabelledCloud, HasAtMost4096PropertiesInPly) {
  EXPECT_EQ(written(with_histogram(4091), ScanFormat::ply).fields.size(), 4096U);
  const test::TemporaryFolder folder;
  const PointCloud cloud = with_histogram(4092);
  const std::string message = message_of<Error>(
      [&] { write_labelled_cloud(folder / "a.ply", ScanFormat::ply, cloud, kLabels, kHeights); });
  EXPECT_TRUE(contains(message, "a.ply: expected at most 4096 numbers a point"));
  EXPECT_TRUE(contains(message, "got 4097; write them with --clouds pcd"));
  EXPECT_TRUE(test::files_below(folder.path()).empty());
  EXPECT_EQ(written(cloud, ScanFormat::pcd).find("h")->count, 4092U);
}

TEST(LabelledCloud, MustHaveOneAnswerAPoint) {
  const test::TemporaryFolder folder;
  const PointCloud cloud = every_type(CloudEncoding::binary);
  const std::vector<std::uint32_t> few(3);
  EXPECT_TRUE(contains(message_of<std::invalid_argument>([&] {
                         write_labelled_cloud(folder / "a", ScanFormat::pcd, cloud, few, kHeights);
                       }),
                       "4 points, but 3 labels and 4 heights"));
  EXPECT_THROW(write_labelled_cloud(folder / "a", ScanFormat::pcd, cloud, kLabels, {}),
               std::invalid_argument);
  EXPECT_THROW(write_labelled_cloud(folder / "a", ScanFormat::kitti, cloud, kLabels, kHeights),
               std::invalid_argument);
  EXPECT_TRUE(test::files_below(folder.path()).empty());
}

TEST(LabelledCloud, LeavesNothingWhereItCannotBeWritten) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  const PointCloud cloud = every_type(CloudEncoding::binary);
  for (const ScanFormat format : {ScanFormat::pcd, ScanFormat::ply}) {
    EXPECT_THROW(write_labelled_cloud(folder / "taken", format, cloud, kLabels, kHeights), Error);
    EXPECT_THROW(write_labelled_cloud(folder / "none/a", format, cloud, kLabels, kHeights), Error);
  }
  EXPECT_TRUE(test::files_below(folder.path()).empty());
}

using RealLabelledCloud = test::WithSharedData;

TEST_F(RealLabelledCloud, KeepsAnOrganisedCompressedScan) {
  const test::TemporaryFolder folder;
  PointCloud cloud;
  read_scan(data() / "pcd/patchwork_128beam_binary_compressed.pcd", ScanFormat::pcd, cloud);
  const std::vector<std::uint32_t> labels(cloud.size(), 40);
  const std::vector<float> heights(cloud.size(), 0.5F);
  PointCloud result;
  for (const CloudEncoding encoding : {CloudEncoding::binary_compressed, CloudEncoding::ascii}) {
    cloud.encoding = encoding;
    write_labelled_cloud(folder / "a.pcd", ScanFormat::pcd, cloud, labels, heights);
    read_scan(folder / "a.pcd", ScanFormat::pcd, result);
    EXPECT_EQ(result.encoding, encoding);
    EXPECT_EQ(result.height, 128U);
    expect_fields_kept(cloud, result);
    EXPECT_EQ(values_of(result, "label"), Values(cloud.size(), 40.0));
  }
}

}  // namespace
}  // namespace groundgrid::io
