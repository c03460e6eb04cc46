#include "io/error.hpp"

#include <gtest/gtest.h>

namespace groundgrid::io {
namespace {

TEST(Error, NamesFilePlaceAndRemedyInOneSentence) {
  const Error error({.file = "a/poses.txt",
                     .line = 3,
                     .expected = "12 numbers",
                     .got = "11 numbers",
                     .remedy = "mend it"});
  EXPECT_STREQ(error.what(), "a/poses.txt, line 3: expected 12 numbers, got 11 numbers; mend it");
}

TEST(Error, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(Error({.file = "x", .expected = "a file", .got = "a directory"}).what(),
               "x: expected a file, got a directory");
  EXPECT_STREQ(Error({.file = "x", .offset = 16, .expected = "more", .got = "less"}).what(),
               "x, byte 16: expected more, got less");
}

TEST(Error, SendsNoControlCharactersToATerminal) {
  const std::string file("a\x1b]0;b\x07\n\x7f\0", 10);
  const Error error({.file = file, .expected = "a\tb", .got = "\x1b[2J", .remedy = "c\rd"});
  EXPECT_STREQ(error.what(), "a?]0;b????: expected a?b, got ?[2J; c?d");
  EXPECT_EQ(error.details().file, file);
  EXPECT_EQ(error.details().got, "\x1b[2J");
  // Letters beyond ASCII stay.
  EXPECT_STREQ(Error({.file = "Stra\u00dfe", .expected = "\u2264 1", .got = "2"}).what(),
               "Stra\u00dfe: expected \u2264 1, got 2");
}

TEST(ErrorText, ShowsWhatIsPrintableOfAFile) {
  EXPECT_EQ(in_quotes("DATA zipped"), "'DATA zipped'");
  EXPECT_EQ(in_quotes(std::string_view("\x00\x1f\x7f\xc3\xa4~ ", 7)), "'?????~ '");
  EXPECT_EQ(in_quotes(""), "''");
}

TEST(ErrorText, CutsWhatIsLong) {
  EXPECT_EQ(in_quotes(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(in_quotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace groundgrid::io
