#include "rendering/png_file.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "read_png.hpp"
#include "support/limited_file_size.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::rendering {
namespace {

using test::TemporaryFolder;

Image some_image() {
  Image image{.size = {64, 48}};
  for (std::uint32_t i = 0; i < 64 * 48; ++i)
    image.pixels.push_back(0xFF000000U | (i * 2654435761U & 0xFFFFFFU));
  return image;
}

TEST(PngFile, HoldsEveryPixel) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", some_image());
  const Image read = test::read_png(folder / "a.png");
  EXPECT_EQ(read.size, some_image().size);
  EXPECT_EQ(read.pixels, some_image().pixels);
  EXPECT_EQ(test::files_below(folder.path()), (test::Names{"a.png"}));
}

TEST(PngFile, SaysWhereTheFolderIsMissing) {
  const TemporaryFolder folder;
  const std::string message =
      test::message_of<io::Error>([&] { write_png(folder / "none" / "a.png", some_image()); });
  EXPECT_TRUE(test::contains(message, "none/a.png"));
}

TEST(PngFile, LeavesNothingWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  {
    const test::LimitedFileSize limit(1000);
    EXPECT_THROW(write_png(folder / "a.png", some_image()), io::Error);
  }
  EXPECT_TRUE(test::files_below(folder.path()).empty());
}

}  // namespace
}  // namespace groundgrid::rendering
