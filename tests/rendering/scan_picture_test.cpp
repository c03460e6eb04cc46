#include "rendering/scan_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

constexpr ImageSize kScanSize{600, 600};

// One point of each group, far from each other and from the words.
struct SmallScan {
  std::vector<float> coordinates = {20.0F, 0.0F, 0.0F, 0.0F, 10.0F, 5.0F, -10.0F, -10.0F, 0.0F};
  std::vector<std::uint8_t> group = std::vector<std::uint8_t>(3);

  SmallScan() { std::iota(group.begin(), group.end(), std::uint8_t{0}); }

  [[nodiscard]] ScanPicture picture() const {
    return {.coordinates = coordinates,
            .group = group,
            .styles = {{"ground", kBluishGreen, 4.0},
                       {"obstacle", kVermilion, 4.0},
                       {"outlier", kBlue, 4.0}},
            .range_m = 40.0};
  }
};

// Where the picture of the scan shows a point: x ahead is up, y to the left is left.
std::array<int, 2> pixel_of_point(double x_m, double y_m) {
  const Rectangle plot = Figure(kScanSize, {.legend = legend_of(SmallScan().picture())}).plot();
  const double scale = std::min(plot.width, plot.height) / 80.0;
  return {static_cast<int>(plot.middle().x - scale * y_m),
          static_cast<int>(plot.middle().y - scale * x_m)};
}

TEST(ScanPicture, ShowsEveryPointInTheColourOfItsGroupWhereItLies) {
  const Image image = draw_scan_from_above(SmallScan().picture(), kScanSize);
  const auto ahead = pixel_of_point(20.0, 0.0);
  const auto left = pixel_of_point(0.0, 10.0);
  const auto behind_right = pixel_of_point(-10.0, -10.0);
  EXPECT_LT(ahead[1], 200);
  EXPECT_LT(left[0], 300);
  EXPECT_GT(behind_right[0], 300);
  EXPECT_EQ(image.at(ahead[0], ahead[1]), kBluishGreen);
  EXPECT_EQ(image.at(left[0], left[1]), kVermilion);
  EXPECT_EQ(image.at(behind_right[0], behind_right[1]), kBlue);
}

TEST(ScanPicture, DrawsLaterGroupsOverEarlierOnes) {
  SmallScan scan;
  scan.coordinates = {20.0F, 0.0F, 0.0F, 20.0F, 0.0F, 0.0F, 20.0F, 0.0F, 0.0F};
  std::rotate(scan.group.begin(), scan.group.begin() + 2, scan.group.end());
  const auto place = pixel_of_point(20.0, 0.0);
  EXPECT_EQ(draw_scan_from_above(scan.picture(), kScanSize).at(place[0], place[1]), kBlue);
}

TEST(ScanPicture, PointsThatAreNoNumbersOrFarAwayAreNotDrawn) {
  SmallScan scan;
  scan.coordinates = {std::nanf(""), 0.0F, 0.0F, 0.0F, 1e30F, 0.0F, 300.0F, 0.0F, 0.0F};
  const Image image = draw_scan_from_above(scan.picture(), kScanSize);
  const Image empty = draw_scan_from_above(
      {.coordinates = {}, .group = {}, .styles = scan.picture().styles, .range_m = 40.0},
      kScanSize);
  const Rectangle plot = Figure(kScanSize, {.legend = legend_of(scan.picture())}).plot();
  for (int y = 0; y < static_cast<int>(plot.bottom()); ++y)
    for (int x = 0; x < kScanSize.width; ++x) ASSERT_EQ(image.at(x, y), empty.at(x, y));
}

TEST(ScanPicture, TheLegendTellsTheShareOfEachGroup) {
  SmallScan scan;
  scan.group.assign(2000, 0);
  scan.group[7] = 2;
  const auto legend = legend_of(scan.picture());
  ASSERT_EQ(legend.size(), 3U);
  EXPECT_EQ(legend[0].text, "ground 99.9 %");
  EXPECT_EQ(legend[1].text, "obstacle 0 %");
  EXPECT_EQ(legend[2].text, "outlier <0.1 %");
  EXPECT_EQ(legend[2].color, kBlue);
}

TEST(ScanPicture, IsTheSameTwice) {
  EXPECT_EQ(draw_scan_from_above(SmallScan().picture(), kScanSize).pixels,
            draw_scan_from_above(SmallScan().picture(), kScanSize).pixels);
}

TEST(ScanPicture, NeedsAGroupForEachPoint) {
  SmallScan scan;
  scan.group.pop_back();
  EXPECT_THROW((void)draw_scan_from_above(scan.picture(), kScanSize), std::invalid_argument);
}

}  // namespace
}  // namespace groundgrid::rendering
