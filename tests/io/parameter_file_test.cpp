#include "program/parameter_file.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "program/usage_error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::program {
namespace {

using test::contains;
using test::message_of;

std::vector<FileParameter> read(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "p.toml", text);
  return read_parameter_file(folder / "p.toml");
}

TEST(ParameterFile, TakesBareAndQuotedValues) {
  const auto given =
      read("a = -1.5e+3\nb=\"# 2 'x'\" # comment\r\n\n  # more\n'c' = 'none'\n\td = on");
  ASSERT_EQ(given.size(), 4U);
  EXPECT_EQ(given[0].name, "a");
  EXPECT_EQ(given[0].value, "-1.5e+3");
  EXPECT_TRUE(given[0].place.ends_with("p.toml, line 1"));
  EXPECT_EQ(given[1].value, "# 2 'x'");
  EXPECT_EQ(given[2].name, "c");
  EXPECT_EQ(given[2].value, "none");
  EXPECT_TRUE(given[3].place.ends_with("p.toml, line 6"));
  EXPECT_EQ(given[3].value, "on");
}

TEST(ParameterFile, MayHoldNothing) {
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read(" # nothing\n\n").empty());
}

class BadValue : public ::testing::TestWithParam<const char*> {};

TEST_P(BadValue, IsRefusedWithFileLineAndName) {
  const std::string message = message_of<UsageError>(
      [] { read("a = 1\nmap_extent_m = " + std::string(GetParam()) + "\nb = 2\n"); });
  EXPECT_TRUE(contains(message, "p.toml, line 2: map_extent_m: expected one number"));
}

INSTANTIATE_TEST_SUITE_P(Values, BadValue,
                         ::testing::Values("[120", "[120]", "120]", "[1, 2]", "[", "{a = 1}", "",
                                           "# 3", "120 130", "1, 2", "\"120", "120\"", "'120\"",
                                           "\"\"\"120", "\"1\" \"2\"", "=120"));

TEST(ParameterFile, RefusesOtherLines) {
  EXPECT_TRUE(contains(message_of<UsageError>([] { read("[map]\ncell_size_m = 1\n"); }),
                       "p.toml, line 1: [map]: parameters stand at the top level"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { read("\ncell_size_m 1\n"); }),
                       "p.toml, line 2: expected name = value, got 'cell_size_m 1'"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { read("cell_size_m\n"); }), "name = value"));
  EXPECT_TRUE(contains(message_of<UsageError>([] { read("= 1\n"); }), "name = value"));
  EXPECT_THROW(read_parameter_file("/nowhere/p.toml"), io::Error);
}

}  // namespace
}  // namespace groundgrid::program
