#include "rendering/canvas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <new>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

using test::count_of;

TEST(Canvas, IsWhiteAtFirst) {
  Canvas canvas({7, 5});
  const Image image = canvas.image();
  EXPECT_EQ(image.size, (ImageSize{7, 5}));
  EXPECT_EQ(count_of(image, kWhite), 35U);
}

TEST(Canvas, FillsExactlyTheWholePixelsOfARectangle) {
  Canvas canvas({10, 10});
  canvas.fill({2, 3, 4, 5}, kBlue);
  const Image image = canvas.image();
  EXPECT_EQ(count_of(image, kBlue), 20U);
  EXPECT_EQ(image.at(2, 3), kBlue);
  EXPECT_EQ(image.at(5, 7), kBlue);
  EXPECT_EQ(image.at(6, 8), kWhite);
}

TEST(Canvas, MixesWhatIsHalfTransparent) {
  Canvas canvas({3, 3});
  canvas.fill({0, 0, 3, 3}, kBlack, 0.6);
  EXPECT_EQ(canvas.image().at(1, 1), (Color{102, 102, 102}));
}

TEST(Canvas, DrawsADiscWhereItIsAndNoFarther) {
  Canvas canvas({21, 21});
  canvas.disc({10.5, 10.5}, 5.0, kVermilion);
  const Image image = canvas.image();
  EXPECT_EQ(image.at(10, 10), kVermilion);
  EXPECT_EQ(image.at(14, 10), kVermilion);
  EXPECT_EQ(image.at(17, 10), kWhite);
  EXPECT_EQ(image.at(15, 15), kWhite) << "the corner of its square";
}

TEST(Canvas, DrawsNothingOutsideOfTheClip) {
  Canvas canvas({10, 10});
  canvas.clip({0, 0, 5, 10});
  canvas.fill({0, 0, 10, 10}, kBlue);
  canvas.unclip();
  EXPECT_EQ(count_of(canvas.image(), kBlue), 50U);
  canvas.fill({0, 0, 10, 10}, kBlue);
  EXPECT_EQ(count_of(canvas.image(), kBlue), 100U);
}

TEST(Canvas, PastesAnImageUprightWithSquarePixels) {
  const Image four{
      .size = {2, 2},
      .pixels = {pixel_of(kBlue), pixel_of(kOrange), pixel_of(kYellow), pixel_of(kBlack)}};
  Canvas canvas({8, 8});
  canvas.paste(four, {2, 2, 4, 4});
  const Image image = canvas.image();
  EXPECT_EQ(image.at(2, 2), kBlue);
  EXPECT_EQ(image.at(5, 2), kOrange);
  EXPECT_EQ(image.at(2, 5), kYellow);
  EXPECT_EQ(image.at(5, 5), kBlack);
  EXPECT_EQ(count_of(image, kBlue), 4U);
  EXPECT_EQ(count_of(image, kWhite), 48U);
}

TEST(Canvas, AnchorsTextAtItsEnds) {
  const Font font{.size_px = 20.0, .color = kBlack};
  const auto columns_with_ink = [&font](Anchor anchor) {
    Canvas canvas({200, 40});
    canvas.text("HHHH", {100, 30}, anchor, font);
    const Image image = canvas.image();
    std::array<int, 2> ends{200, -1};
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 200; ++x)
        if (image.at(x, y) != kWhite) ends = {std::min(ends[0], x), std::max(ends[1], x)};
    return ends;
  };
  const int width = static_cast<int>(Canvas({1, 1}).text_width("HHHH", font));
  EXPECT_GT(width, 40);
  EXPECT_NEAR(columns_with_ink(Anchor::left)[0], 100, 4);
  EXPECT_NEAR(columns_with_ink(Anchor::right)[1], 100, 4);
  EXPECT_NEAR(columns_with_ink(Anchor::middle)[0], 100 - width / 2, 4);
}

TEST(Canvas, DrawsTextThatIsNoUtf8) {
  Canvas canvas({100, 30});
  canvas.text("a\xff\x01", {5, 20}, Anchor::left, {});
  Canvas marked({100, 30});
  marked.text("a??", {5, 20}, Anchor::left, {});
  EXPECT_EQ(canvas.image().pixels, marked.image().pixels);
}

}  // namespace
}  // namespace groundgrid::rendering
