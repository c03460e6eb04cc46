#include "program/parameter_file.hpp"

#include <gtest/gtest.h>

#include "groundgrid/parameters.hpp"
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

std::string message_for(const std::string& text) {
  return message_of<UsageError>([&text] { read(text); });
}

TEST(ParameterFile, TakesNumbersStringsAndBooleans) {
  const auto given =
      read("a = -1.5e+3\nb=\"# 2 'x'\" # comment\r\n\n  # more\n'c' = 'none'\n\td = true");
  ASSERT_EQ(given.size(), 4U);
  EXPECT_EQ(given[0].name, "a");
  EXPECT_EQ(given[0].value, "-1500");
  EXPECT_TRUE(given[0].place.ends_with("p.toml, line 1"));
  EXPECT_EQ(given[1].value, "# 2 'x'");
  EXPECT_EQ(given[2].name, "c");
  EXPECT_EQ(given[2].value, "none");
  EXPECT_TRUE(given[3].place.ends_with("p.toml, line 6"));
  EXPECT_EQ(given[3].value, "true");
}

TEST(ParameterFile, KeepsEveryDigitOfANumber) {
  const auto given = read("a = 0.1\nb = 5e-05\nc = 0.30000000000000004\nd = 1_000\ne = 0x10\n");
  ASSERT_EQ(given.size(), 5U);
  EXPECT_EQ(given[0].value, "0.1");
  EXPECT_EQ(given[1].value, "5e-05");
  EXPECT_EQ(given[2].value, "0.30000000000000004");
  EXPECT_EQ(given[3].value, "1000");
  EXPECT_EQ(given[4].value, "16");
}

TEST(ParameterFile, ListsKeepTheirOrder) {
  const auto given = read("anchor_m = [1, -2.5] # x, y\n");
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given[0].value, "[1, -2.5]");
}

TEST(ParameterFile, MayHoldNothing) {
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read(" # nothing\n\n").empty());
  EXPECT_TRUE(read("\xEF\xBB\xBF").empty());
  EXPECT_TRUE(read("# [" + std::string(2000, '[')).empty());
}

class BadValue : public ::testing::TestWithParam<const char*> {};

TEST_P(BadValue, IsRefusedWithFileLineAndName) {
  const std::string message =
      message_for("a = 1\nextent_m = " + std::string(GetParam()) + "\nb = 2\n");
  EXPECT_TRUE(contains(message, "p.toml, line 2: extent_m: expected a number")) << message;
  EXPECT_FALSE(contains(message, "\n"));
}

INSTANTIATE_TEST_SUITE_P(Values, BadValue,
                         ::testing::Values("[120", "[[120]]", "120]", "[1, {a = 2}]", "[", "{a = 1",
                                           "", "# 3", "120 130", "1, 2", "\"120", "120\"", "'120\"",
                                           "\"\"\"120", "\"1\" \"2\"", "=120", "on", "1.", ".5",
                                           "01", "\"\\q\"", "2026-11-22", "12:00:00"));

// toml11 alone would read beyond its buffer where text is not UTF-8.
TEST(ParameterFile, SeesNoOtherLettersThanThoseOfAscii) {
  const auto given = read("\xEF\xBB\xBF'\xDC\xDC' = \"\xFF\" # m\xC2\xB2, \xFF\nb = 1\n");
  ASSERT_EQ(given.size(), 2U);
  EXPECT_EQ(given[0].name, "??");
  EXPECT_EQ(given[0].value, "?");
  EXPECT_EQ(given[1].name, "b");
}

TEST(ParameterFile, SaysWhyAValueIsNone) {
  EXPECT_TRUE(
      message_for("resolution_m = .5\n")
          .ends_with("p.toml, line 1: resolution_m: expected a number, a list of numbers or "
                     "a quoted word, got '.5' (bad float: invalid format)"));
  EXPECT_TRUE(message_for("anchor_m = [[1]]\n").ends_with("got '[[1]]' (array)"));
  EXPECT_TRUE(contains(message_for("resolution_m =\n"), "got nothing (key_value_pair: missing"));
}

TEST(ParameterFile, RefusesOtherLines) {
  EXPECT_TRUE(contains(message_for("[map]\nresolution_m = 1\n"),
                       "p.toml, line 1: [map]: parameters stand at the top level"));
  EXPECT_TRUE(contains(message_for("map.resolution_m = 1\n"),
                       "p.toml, line 1: map.resolution_m = 1: parameters stand at the top level"));
  EXPECT_TRUE(contains(message_for("map = {resolution_m = 1}\n"), "parameters stand at the top"));
  EXPECT_TRUE(contains(message_for("\nresolution_m 1\n"),
                       "p.toml, line 2: expected name = value, got 'resolution_m 1'"));
  EXPECT_TRUE(contains(message_for("resolution_m\n"), "name = value"));
  EXPECT_TRUE(contains(message_for("= 1\n"), "name = value"));
  EXPECT_THROW(read_parameter_file("/nowhere/p.toml"), io::Error);
}

// toml11 alone runs out of stack here.
TEST(ParameterFile, RefusesNestingWithoutFollowingIt) {
  const std::string deep(30000, '[');
  EXPECT_TRUE(contains(message_for("a = " + deep + "\n"),
                       "line 1: expected name = value in at most 500 bytes, got 30004: 'a = [[["));
  EXPECT_TRUE(contains(message_for(deep), "[...: parameters stand at the top level"));
  EXPECT_TRUE(contains(message_for("a = " + std::string(496, '[')), "a: expected a number"));
  EXPECT_TRUE(contains(message_for("a" + std::string(30000, '\n') + "b"), "line 1: expected name"));
}

TEST(ParameterFile, RefusesWhatIsTooLongForOne) {
  const std::string message = message_of<io::Error>([] { read(std::string(65536, '#') + "\n"); });
  EXPECT_TRUE(contains(message, "at most 65536 bytes, got 65537 bytes"));
  EXPECT_TRUE(read(std::string(65536, '#')).empty());
}

// What set_parameter says of the one value in this file.
std::string refusal_of(const std::string& value) {
  const auto given = read("resolution_m = " + value + "\n");
  return message_of<std::invalid_argument>([&given] {
    Config config;
    set_parameter(config, given.at(0).name, given.at(0).value);
  });
}

TEST(ParameterFile, LeavesInfiniteNumbersToTheRanges) {
  for (const char* number : {"inf", "-inf", "nan"})
    EXPECT_TRUE(contains(refusal_of(number), "not a number"));
  EXPECT_TRUE(contains(refusal_of("1e400"), "resolution_m"));
  EXPECT_TRUE(contains(refusal_of("1e400"), "must be between"));
}

}  // namespace
}  // namespace groundgrid::program
