#include "rendering/text.hpp"

#include <gtest/gtest.h>

namespace groundgrid::rendering {
namespace {

TEST(PictureText, KeepsValidUtf8OfAnyLength) {
  const std::string text = "a \u00e9 \u2026 \U0001F600";
  EXPECT_EQ(drawable(text), text);
}

TEST(PictureText, MarksControlCharactersAndWhatIsNoUtf8) {
  EXPECT_EQ(drawable("a\n\x7f"), "a??");
  EXPECT_EQ(drawable("\xff"), "?");
  EXPECT_EQ(drawable("\xc3"), "?") << "cut off";
  EXPECT_EQ(drawable("\xc3("), "?(") << "no continuation";
  EXPECT_EQ(drawable("\xc0\x80"), "??") << "longer than need be";
  EXPECT_EQ(drawable("\xe0\x80\x80"), "???") << "longer than need be";
  EXPECT_EQ(drawable("\xed\xa0\x80"), "???") << "half of a surrogate pair";
  EXPECT_EQ(drawable("\xf4\x90\x80\x80"), "????") << "beyond Unicode";
}

TEST(PictureText, LosesWholeCharacters) {
  EXPECT_EQ(without_last_character("ab"), "a");
  EXPECT_EQ(without_last_character("a\u2026"), "a");
  EXPECT_EQ(without_last_character(""), "");
}

}  // namespace
}  // namespace groundgrid::rendering
