#include "io/semantic_kitti_labels.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "oversized_file.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

TEST(SemanticKittiLabels, SurviveWritingAndReading) {
  const test::TemporaryFolder folder;
  const std::vector<std::uint32_t> written{0, 40, 99, 0xFFFF'FFFFU, 0x0002'0028U};
  write_labels(folder / "a.label", written);
  std::vector<std::uint32_t> labels;
  read_labels(folder / "a.label", "a.bin", written.size(), labels);
  EXPECT_EQ(labels, written);
}

TEST(SemanticKittiLabels, AreLittleEndianOnDisk) {
  const test::TemporaryFolder folder;
  write_labels(folder / "a.label", std::vector<std::uint32_t>{0x0102'0304U});
  EXPECT_EQ(test::read_file(folder / "a.label"), "\x04\x03\x02\x01");
}

TEST(SemanticKittiLabels, KeepTheClassInTheLowHalf) {
  EXPECT_EQ(semantic_kitti_class(0x0002'0028U), 40);
  EXPECT_EQ(semantic_kitti_class(0xFFFF'00FCU), 252);
}

TEST(SemanticKittiLabels, StandForOurAnswers) {
  EXPECT_EQ(semantic_kitti_label(Label::ground), 40U);
  EXPECT_EQ(semantic_kitti_label(Label::obstacle), 99U);
  EXPECT_EQ(semantic_kitti_label(Label::outlier), 1U);
  EXPECT_EQ(semantic_kitti_label(Label::unknown), 0U);
}

TEST(SemanticKittiLabels, MustBeAsManyAsThePoints) {
  const test::TemporaryFolder folder;
  write_labels(folder / "a.label", std::vector<std::uint32_t>(7));
  std::vector<std::uint32_t> labels;
  for (const std::size_t points : {std::size_t{6}, std::size_t{8}, std::size_t{0}}) {
    const std::string message =
        message_of<Error>([&] { read_labels(folder / "a.label", "a.bin", points, labels); });
    EXPECT_TRUE(contains(message, "a.label: expected " + std::to_string(points) + " labels"));
    EXPECT_TRUE(contains(message, "each point of a.bin, got 28 bytes, which is 7 labels"));
  }
}

TEST(SemanticKittiLabels, MustBeWhole) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.label", "12345");
  std::vector<std::uint32_t> labels;
  EXPECT_THROW(read_labels(folder / "a.label", "a.bin", 1, labels), Error);
}

using OversizedLabels = test::OversizedFile;

TEST_F(OversizedLabels, AreNamed) {
  test::make_sparse_file(folder / "huge.label", kBytes);
  std::vector<std::uint32_t> labels;
  const std::string message = message_of<Error>([&] {
    read_labels(folder / "huge.label", "huge.bin", kBytes / sizeof(std::uint32_t), labels);
  });
  EXPECT_TRUE(contains(message, "huge.label: expected a file that fits into memory"));
}

}  // namespace
}  // namespace groundgrid::io
