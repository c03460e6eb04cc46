#include "io/bin_scan.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "oversized_file.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

TEST(BinScan, ReadsPointsAsTheyLie) {
  const test::TemporaryFolder folder;
  const std::vector<float> written{1.0F, 2.0F, 3.0F, 0.5F, -1.0F, -2.0F, -3.0F, 0.25F};
  test::write_numbers(folder / "scan.bin", written);
  std::vector<float> points;
  read_bin_scan(folder / "scan.bin", points);
  EXPECT_EQ(points, written);
}

TEST(BinScan, ReusesMemoryAndForgetsTheLastScan) {
  const test::TemporaryFolder folder;
  test::write_numbers(folder / "long.bin", std::vector<float>(400, 1.0F));
  test::write_numbers(folder / "short.bin", std::vector<float>(8, 2.0F));
  std::vector<float> points;
  read_bin_scan(folder / "long.bin", points);
  const float* const memory = points.data();
  read_bin_scan(folder / "short.bin", points);
  EXPECT_EQ(points, std::vector<float>(8, 2.0F));
  EXPECT_EQ(points.data(), memory);
}

TEST(BinScan, TakesAnEmptyFileAsNoPoints) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "empty.bin", "");
  std::vector<float> points(4);
  read_bin_scan(folder / "empty.bin", points);
  EXPECT_TRUE(points.empty());
}

TEST(BinScan, RejectsATruncatedFileAndSaysWhere) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "cut.bin", std::string(16 * 3 + 5, 'x'));
  std::vector<float> points;
  const std::string message = message_of<Error>([&] { read_bin_scan(folder / "cut.bin", points); });
  EXPECT_TRUE(contains(message, (folder / "cut.bin").string()));
  EXPECT_TRUE(contains(message, "byte 48"));
  EXPECT_TRUE(contains(message, "got 5 bytes"));
}

TEST(BinScan, RejectsWhatIsNoFile) {
  const test::TemporaryFolder folder;
  std::vector<float> points;
  EXPECT_TRUE(contains(message_of<Error>([&] { read_bin_scan(folder / "none.bin", points); }),
                       "none.bin: expected a file, got nothing of that name"));
  EXPECT_TRUE(contains(message_of<Error>([&] { read_bin_scan(folder.path(), points); }),
                       "expected a file, got a directory"));
  EXPECT_TRUE(contains(message_of<Error>([&] { read_bin_scan("/dev/null", points); }),
                       "expected a regular file"));
}

using OversizedScan = test::OversizedFile;

TEST_F(OversizedScan, IsNamed) {
  test::make_sparse_file(folder / "huge.bin", kBytes);
  std::vector<float> points(4, 1.0F);
  const std::string message =
      message_of<Error>([&] { read_bin_scan(folder / "huge.bin", points); });
  EXPECT_TRUE(contains(message, (folder / "huge.bin").string()));
  EXPECT_TRUE(contains(message, "expected a file that fits into memory, got 17179869184 bytes"));
  EXPECT_EQ(points.size(), 4U);
}

}  // namespace
}  // namespace groundgrid::io
