#include "io/text.hpp"

#include <gtest/gtest.h>

namespace groundgrid::io {
namespace {

TEST(Text, IsTrimmedOfBlanksOfAllKinds) {
  EXPECT_EQ(trimmed(" \t\v\fa b\r"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \r"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Text, IsTakenWordByWord) {
  std::string_view line = " one\ttwo \r";
  EXPECT_EQ(take_word(line), "one");
  EXPECT_EQ(line, "\ttwo \r");
  EXPECT_EQ(take_word(line), "two");
  EXPECT_EQ(take_word(line), "");
  EXPECT_EQ(take_word(line), "");
}

TEST(Text, EndsWithLettersOfAnyCase) {
  EXPECT_TRUE(ends_with_in_any_case("a.PcD", ".pCd"));
  EXPECT_TRUE(ends_with_in_any_case("AZ", "az"));
  EXPECT_TRUE(ends_with_in_any_case("a", ""));
  EXPECT_FALSE(ends_with_in_any_case("a.pcd.bin", ".pcd"));
  EXPECT_FALSE(ends_with_in_any_case("pcd", ".pcd"));
  // '[' and '{' are 32 apart, as 'A' and 'a' are.
  EXPECT_FALSE(ends_with_in_any_case("a[", "a{"));
}

}  // namespace
}  // namespace groundgrid::io
