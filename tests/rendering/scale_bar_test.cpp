#include "rendering/scale_bar.hpp"

#include <gtest/gtest.h>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

// The longest run of pixels of that colour in any row.
int longest_run(const Image& image, Color color) {
  int longest = 0;
  for (int y = 0; y < image.size.height; ++y) {
    int run = 0;
    for (int x = 0; x < image.size.width; ++x) {
      run = image.at(x, y) == color ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST(ScaleBar, IsARoundLengthOfAtMostAQuarterOfThePlot) {
  EXPECT_DOUBLE_EQ(scale_bar_length(800.0, 10.0), 20.0);
  EXPECT_DOUBLE_EQ(scale_bar_length(800.0, 9.9), 20.0);
  EXPECT_DOUBLE_EQ(scale_bar_length(800.0, 10.1), 10.0);
}

TEST(ScaleBar, HasTheLengthInPixelsThatItSays) {
  Canvas canvas({400, 200});
  draw_scale_bar(canvas, {0, 0, 400, 200}, 4.0, 12.0);
  EXPECT_EQ(longest_run(canvas.image(), kInk), 80) << "20 m at 4 pixels a metre";
}

TEST(ScaleBar, LiesInTheLowerLeftCornerAndTheArrowInTheUpperRight) {
  Canvas canvas({400, 200});
  draw_scale_bar(canvas, {100, 50, 300, 150}, 4.0, 12.0);
  draw_up_arrow(canvas, {100, 50, 300, 150}, "north", 12.0);
  const Image image = canvas.image();
  std::size_t bar = 0;
  std::size_t arrow = 0;
  for (int y = 50; y < 200; ++y)
    for (int x = 100; x < 400; ++x) {
      if (image.at(x, y) != kInk) continue;
      if (x < 200 && y > 150) ++bar;
      if (x > 340 && y < 110) ++arrow;
    }
  EXPECT_GT(bar, 100U);
  EXPECT_GT(arrow, 20U);
  EXPECT_EQ(bar + arrow, test::count_of(image, kInk));
}

}  // namespace
}  // namespace groundgrid::rendering
