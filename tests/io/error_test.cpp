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

}  // namespace
}  // namespace groundgrid::io
