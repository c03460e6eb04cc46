#include "io/csv_field.hpp"

#include <gtest/gtest.h>

namespace groundgrid::io {
namespace {

TEST(CsvField, LeavesPlainTextAsItIs) {
  EXPECT_EQ(csv_field("00"), "00");
  EXPECT_EQ(csv_field("a b;c'd"), "a b;c'd");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, QuotesWhatWouldEndTheField) {
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

}  // namespace
}  // namespace groundgrid::io
