#include "geotiff/height_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <vector>

#include "io/error.hpp"
#include "io/temporary_folder.hpp"
#include "read_raster.hpp"
#include "support/limited_file_size.hpp"

namespace groundgrid::geotiff {
namespace {

const RasterGrid kGrid{10.0, -2.0, 0.5, 3, 2};
const std::vector<float> kHeights{1, 2, 3, 4, 5, 6};

// That do not become few bytes where they are compressed.
std::vector<float> numbers(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> between(0.0F, 100.0F);
  std::vector<float> numbers(count);
  std::generate(numbers.begin(), numbers.end(), [&] { return between(random); });
  return numbers;
}

std::filesystem::path place() {
  return std::filesystem::path(::testing::TempDir()) / "heights.tif";
}

TEST(HeightFile, IsNorthUpWithTheSouthernRowLast) {
  write_heights(place(), kGrid, kHeights);
  const test::Raster raster = test::read_raster(place());
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 2);
  EXPECT_EQ(raster.transform, (std::array<double, 6>{10.0, 0.5, 0.0, -1.0, 0.0, -0.5}));
  ASSERT_EQ(raster.bands.size(), 1U);
  EXPECT_EQ(raster.bands[0].name, "height");
  EXPECT_EQ(raster.bands[0].unit, "m");
  EXPECT_EQ(raster.bands[0].no_data, -9999.0);
  EXPECT_EQ(raster.bands[0].pixels, (std::vector<float>{4, 5, 6, 1, 2, 3}));
  std::filesystem::remove(place());
}

TEST(HeightFile, NeedsAHeightForEachCell) {
  EXPECT_THROW(write_heights(place(), {0.0, 0.0, 1.0, 2, 2}, kHeights), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(place()));
}

TEST(HeightFile, LeavesTheOldFileWhereTheDiskIsFull) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.tif", "old");
  const std::vector<float> heights = numbers(300 * 300);
  for (const rlim_t bytes : {0U, 1000U, 100'000U}) {
    const test::LimitedFileSize limit(bytes);
    EXPECT_THROW(write_heights(folder / "a.tif", {0.0, 0.0, 1.0, 300, 300}, heights), io::Error);
  }
  EXPECT_EQ(test::read_file(folder / "a.tif"), "old");
  EXPECT_EQ(test::files_below(folder.path()), (test::Names{"a.tif"}));
}

TEST(HeightFile, SaysWhereItCannotWrite) {
  EXPECT_THROW(write_heights("/nowhere/heights.tif", kGrid, kHeights), io::Error);
}

}  // namespace
}  // namespace groundgrid::geotiff
