#include "rendering/gif_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "image_checks.hpp"
#include "io/error.hpp"
#include "read_gif.hpp"
#include "support/limited_file_size.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::rendering {
namespace {

using test::TemporaryFolder;

constexpr std::array kColors{kBlue, kVermilion};
constexpr ImageSize kSize{30, 20};

Image plain(Color color) {
  return {.size = kSize, .pixels = std::vector<std::uint32_t>(kSize.pixels(), pixel_of(color))};
}

TEST(Palette, HasItsColoursAndWhiteAndBlackExactly) {
  Palette palette(kColors);
  EXPECT_LE(palette.colors().size(), 256U);
  Image image = plain(kBlue);
  image.pixels = {pixel_of(kBlue), pixel_of(kVermilion), pixel_of(kWhite), pixel_of(kBlack)};
  const auto indices = palette.indices(image);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(palette.colors()[indices[i]], color_of(image.pixels[i])) << i;
}

TEST(Palette, TakesTheNearestForEdges) {
  Palette palette(kColors);
  Image image = plain(kBlue);
  // A third of the way from blue (0, 114, 178) to white.
  image.pixels = {pixel_of({85, 161, 204})};
  EXPECT_EQ(palette.colors()[palette.indices(image)[0]], (Color{85, 161, 204}));
}

TEST(Palette, IsFullWithTwelveColours) {
  EXPECT_LE(Palette(std::vector<Color>(12)).colors().size(), 256U);
  EXPECT_THROW(Palette(std::vector<Color>(13)), std::invalid_argument);
}

TEST(GifFile, HoldsItsFramesInOrderAndPlaysForEver) {
  const TemporaryFolder folder;
  GifFile gif(folder / "a.gif", kSize, 8.0, Palette(kColors));
  for (const Color color : {kBlue, kVermilion, kWhite}) gif.add(plain(color));
  gif.commit();
  const test::GifContent content = test::read_gif(folder / "a.gif");
  ASSERT_EQ(content.frames.size(), 3U);
  EXPECT_EQ(content.frames[0].pixels, plain(kBlue).pixels);
  EXPECT_EQ(content.frames[1].pixels, plain(kVermilion).pixels);
  EXPECT_EQ(content.frames[2].pixels, plain(kWhite).pixels);
  EXPECT_EQ(content.frames[2].size, kSize);
  EXPECT_EQ(content.delay, 13) << "an eighth of a second";
  EXPECT_TRUE(content.loops);
}

TEST(GifFile, IsNotThereWithoutCommit) {
  const TemporaryFolder folder;
  {
    GifFile gif(folder / "a.gif", kSize, 10.0, Palette(kColors));
    gif.add(plain(kBlue));
  }
  EXPECT_TRUE(test::files_below(folder.path()).empty());
}

TEST(GifFile, RefusesAFrameOfAnotherSize) {
  const TemporaryFolder folder;
  GifFile gif(folder / "a.gif", {31, 20}, 10.0, Palette(kColors));
  EXPECT_THROW(gif.add(plain(kBlue)), std::invalid_argument);
}

TEST(GifFile, LeavesNothingWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  Image noise = plain(kBlue);
  noise.size = {200, 200};
  noise.pixels.clear();
  for (std::uint32_t i = 0; i < 40000; ++i)
    noise.pixels.push_back(0xFF000000U | (i * 2654435761U & 0xFFFFFFU));
  {
    const test::LimitedFileSize limit(2000);
    EXPECT_THROW(
        {
          GifFile gif(folder / "a.gif", noise.size, 10.0, Palette(kColors));
          gif.add(noise);
          gif.commit();
        },
        io::Error);
  }
  EXPECT_TRUE(test::files_below(folder.path()).empty());
}

TEST(GifFile, SaysWhereTheFolderIsMissing) {
  const TemporaryFolder folder;
  const std::string message = test::message_of<io::Error>(
      [&] { GifFile(folder / "none" / "a.gif", kSize, 10.0, Palette(kColors)); });
  EXPECT_TRUE(test::contains(message, "none/a.gif"));
}

}  // namespace
}  // namespace groundgrid::rendering
