#include "rendering/figure.hpp"

#include <gtest/gtest.h>

#include <string>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

using test::count_of;

TEST(Figure, HasTheSizeAskedForAndItsPlotInside) {
  for (const ImageSize size : {ImageSize{240, 180}, ImageSize{1200, 1000}, ImageSize{4000, 800}}) {
    Figure figure(size, {.title = "title",
                         .caption = "caption",
                         .legend = {{.text = "one", .color = kBlue}},
                         .bar = ColorBar{&height_colors(), 0.0, 10.0, "height (m)"}});
    EXPECT_GT(figure.plot().width, 0.5 * size.width);
    EXPECT_GT(figure.plot().height, 0.4 * size.height);
    EXPECT_LT(figure.plot().right(), size.width);
    EXPECT_LT(figure.plot().bottom(), size.height);
    EXPECT_EQ(figure.finish().size, size);
  }
}

TEST(Figure, ShowsEveryEntryOfTheLegendBelowThePlot) {
  Figure figure({300, 240}, {.legend = {{.text = "the first of many entries", .color = kBlue},
                                        {.text = "another long one", .color = kOrange},
                                        {.text = "last", .color = kReddishPurple}}});
  const Rectangle plot = figure.plot();
  const Image image = figure.finish();
  for (const Color color : {kBlue, kOrange, kReddishPurple}) {
    EXPECT_GT(count_of(image, color), 10U);
    for (int y = 0; y < static_cast<int>(plot.bottom()); ++y)
      for (int x = 0; x < image.size.width; ++x) ASSERT_NE(image.at(x, y), color);
  }
}

TEST(Figure, LeavesMoreRoomToThePlotWithoutWords) {
  const Rectangle bare = Figure({600, 400}, {}).plot();
  EXPECT_LT(bare.y, Figure({600, 400}, {.title = "t"}).plot().y);
  EXPECT_GT(bare.height, Figure({600, 400}, {.legend = {{.text = "a"}}}).plot().height);
}

TEST(Figure, CutsATitleThatIsTooLong) {
  Figure figure({300, 200}, {.title = std::string(200, 'W')});
  const Image image = figure.finish();
  for (int y = 0; y < 200; ++y) EXPECT_EQ(image.at(297, y), kWhite);
  EXPECT_GT(count_of(image, kInk), 100U);
}

TEST(Figure, ShowsTheColoursOfItsBarFromLowBelowToHighAbove) {
  Figure figure({600, 400}, {.bar = ColorBar{&height_colors(), 0.0, 1.0, ""}});
  const int top = static_cast<int>(figure.plot().y) + 2;
  const int bottom = static_cast<int>(figure.plot().bottom()) - 3;
  // In the middle of the bar: a margin and half of its width beside the plot.
  const int x = static_cast<int>(figure.plot().right() + 1.3 * figure.font_px());
  const Image image = figure.finish();
  EXPECT_NEAR(image.at(x, top).red, height_colors().at(1.0).red, 6);
  EXPECT_NEAR(image.at(x, top).blue, height_colors().at(1.0).blue, 6);
  EXPECT_NEAR(image.at(x, bottom).red, height_colors().at(0.0).red, 6);
  EXPECT_NEAR(image.at(x, bottom).green, height_colors().at(0.0).green, 6);
}

TEST(Figure, LettersGrowWithThePictureButAreNeverTiny) {
  EXPECT_DOUBLE_EQ(font_size({240, 180}), 9.0);
  EXPECT_DOUBLE_EQ(font_size({1000, 1000}), 15.5);
  EXPECT_DOUBLE_EQ(font_size({4000, 4000}), 62.0);
}

TEST(Figure, HatchesWhereThereAreNoData) {
  Canvas canvas({100, 100});
  fill_no_data(canvas, {0, 0, 100, 100}, 12.0);
  const Image image = canvas.image();
  EXPECT_EQ(count_of(image, kWhite), 0U);
  const Color ground{232, 232, 232};
  EXPECT_GT(count_of(image, ground), 1000U);
  EXPECT_LT(count_of(image, ground), 9500U) << "one colour alone is no hatch";
}

}  // namespace
}  // namespace groundgrid::rendering
