#include "io/true_heights.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

TEST(TrueHeights, AreReadAsTheyLieOnDisk) {
  const test::TemporaryFolder folder;
  const std::vector<float> written{0.0F, -0.25F, 1.5F};
  test::write_numbers(folder / "a.f32", written);
  std::vector<float> heights;
  read_true_heights(folder / "a.f32", "a.bin", 3, heights);
  EXPECT_EQ(heights, written);
}

TEST(TrueHeights, MustBeAsManyAsThePoints) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.f32", "123456789");
  std::vector<float> heights;
  const std::string message =
      message_of<Error>([&] { read_true_heights(folder / "a.f32", "a.bin", 2, heights); });
  EXPECT_TRUE(
      contains(message, "a.f32: expected 2 heights of 4 bytes, one for each point of a.bin"));
  EXPECT_TRUE(contains(message, "got 9 bytes"));
  EXPECT_THROW(read_true_heights(folder / "b.f32", "a.bin", 2, heights), Error);
}

}  // namespace
}  // namespace groundgrid::io
