#include "io/point_cloud.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "cloud_checks.hpp"

namespace groundgrid::io {
namespace {

TEST(PointCloud, PacksFieldsInTheirOrder) {
  PointCloud cloud;
  cloud.add_field("x", FieldType::float64);
  cloud.add_field("histogram", FieldType::uint16, 3);
  cloud.add_field("ring", FieldType::uint8);
  EXPECT_EQ(cloud.find("histogram")->offset, 8U);
  EXPECT_EQ(cloud.find("histogram")->bytes(), 6U);
  EXPECT_EQ(cloud.find("ring")->offset, 14U);
  EXPECT_EQ(cloud.stride_bytes, 15U);
  EXPECT_EQ(cloud.find("y"), nullptr);
}

TEST(PointCloud, IsEmptyOnceClearedButKeepsItsMemory) {
  PointCloud cloud;
  cloud.add_field("x", FieldType::float32);
  cloud.width = 5;
  cloud.height = 2;
  cloud.data.resize(40);
  cloud.viewpoint = "0 0 0 1 0 0 0";
  cloud.surplus_bytes = 3;
  const std::byte* const memory = cloud.data.data();
  cloud.clear();
  EXPECT_EQ(cloud.size(), 0U);
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud.stride_bytes, 0U);
  EXPECT_TRUE(cloud.fields.empty());
  EXPECT_TRUE(cloud.viewpoint.empty());
  EXPECT_EQ(cloud.surplus_bytes, 0U);
  EXPECT_TRUE(cloud.data.empty());
  cloud.data.resize(40);
  EXPECT_EQ(cloud.data.data(), memory);
}

struct Extreme {
  FieldType type;
  std::vector<unsigned char> bytes;
  double value;
};

class FieldValue : public ::testing::TestWithParam<Extreme> {};

TEST_P(FieldValue, IsReadByItsType) {
  PointCloud cloud;
  cloud.add_field("pad", FieldType::uint8);
  cloud.add_field("v", GetParam().type);
  cloud.width = 1;
  cloud.data.resize(cloud.stride_bytes);
  ASSERT_EQ(GetParam().bytes.size(), size_of(GetParam().type));
  std::memcpy(cloud.data.data() + 1, GetParam().bytes.data(), GetParam().bytes.size());
  EXPECT_EQ(value_at(cloud, 0, cloud.fields[1]), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    EveryType, FieldValue,
    ::testing::Values(Extreme{FieldType::int8, {0x80}, -128.0},
                      Extreme{FieldType::uint8, {0x80}, 128.0},
                      Extreme{FieldType::int16, {0xFE, 0xFF}, -2.0},
                      Extreme{FieldType::uint16, {0xFE, 0xFF}, 65534.0},
                      Extreme{FieldType::int32, {0, 0, 0, 0x80}, -2147483648.0},
                      Extreme{FieldType::uint32, {0, 0, 0, 0x80}, 2147483648.0},
                      Extreme{FieldType::int64, {0, 0, 0, 0, 0, 0, 0, 0xC0}, -0x1p62},
                      Extreme{FieldType::uint64, {0, 0, 0, 0, 0, 0, 0, 0x80}, 0x1p63},
                      Extreme{FieldType::float32, {0, 0, 0x80, 0xBF}, -1.0},
                      Extreme{FieldType::float64, {0, 0, 0, 0, 0, 0, 0xF8, 0x3F}, 1.5}),
    [](const auto& instance) { return std::string(name_of(instance.param.type)); });

TEST(PointCloud, IsSeenWithoutACopyWhereCoordinatesAreFloats) {
  PointCloud cloud;
  for (const char* const name : {"z", "y", "intensity", "x"})
    cloud.add_field(name, FieldType::float32);
  cloud.width = 2;
  cloud.data.resize(32);
  std::vector<float> coordinates;
  const PointView view = point_view(cloud, coordinates);
  EXPECT_EQ(view.data, cloud.data.data());
  EXPECT_EQ(view.count, 2U);
  EXPECT_EQ(view.stride_bytes, 16U);
  EXPECT_EQ(view.x_offset, 12U);
  EXPECT_EQ(view.y_offset, 4U);
  EXPECT_EQ(view.z_offset, 0U);
  EXPECT_TRUE(coordinates.empty());
}

TEST(PointCloud, IsConvertedWhereACoordinateIsNoFloat) {
  const PointCloud cloud = test::read_content(
      "FIELDS y x z\nSIZE 8 4 2\nTYPE F F I\nWIDTH 2\nDATA ascii\n0.1 1 -3\n5 4 6\n",
      ScanFormat::pcd);
  std::vector<float> coordinates;
  const PointView view = point_view(cloud, coordinates);
  EXPECT_EQ(coordinates, (std::vector<float>{1.0F, 0.1F, -3.0F, 4.0F, 5.0F, 6.0F}));
  EXPECT_EQ(view.data, reinterpret_cast<const std::byte*>(coordinates.data()));
  EXPECT_EQ(view.count, 2U);
  EXPECT_EQ(view.stride_bytes, 12U);
}

}  // namespace
}  // namespace groundgrid::io
