#include "io/input_file.hpp"

#include <gtest/gtest.h>

#include <array>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::message_of;

class InputFileTest : public ::testing::Test {
 protected:
  InputFile open(const std::string& content) {
    test::write_file(folder / "file", content);
    return InputFile(folder / "file");
  }

  test::TemporaryFolder folder;
};

TEST_F(InputFileTest, GivesLinesWithoutTheirEnds) {
  InputFile file = open("first\r\n\nthird\rx\nlast");
  EXPECT_EQ(file.read_line(), "first");
  EXPECT_EQ(file.position(), 7U);
  EXPECT_EQ(file.read_line(), "");
  EXPECT_EQ(file.read_line(), "third\rx");
  EXPECT_EQ(file.lines(), 3U);
  EXPECT_EQ(file.remaining(), 4U);
  EXPECT_EQ(file.read_line(), "last");
  EXPECT_EQ(file.remaining(), 0U);
  EXPECT_FALSE(file.read_line());
  EXPECT_EQ(file.lines(), 4U);
}

TEST_F(InputFileTest, GivesBytesFromWhereTheLastLineEnded) {
  InputFile file = open("header\nabcdefgh");
  ASSERT_TRUE(file.read_line());
  EXPECT_EQ(file.peek(3), "abc");
  EXPECT_EQ(file.peek(100), "abcdefgh");
  EXPECT_EQ(file.position(), 7U);
  std::array<char, 2> bytes{};
  file.read(bytes.data(), 2);
  EXPECT_EQ(bytes, (std::array{'a', 'b'}));
  file.skip(3);
  EXPECT_EQ(file.position(), 12U);
  EXPECT_EQ(file.remaining(), 3U);
  file.read(bytes.data(), 2);
  EXPECT_EQ(bytes, (std::array{'f', 'g'}));
}

TEST_F(InputFileTest, SkipsFewAndManyBytes) {
  for (const std::size_t bytes : {0U, 1U, 256U, 257U, 100000U}) {
    InputFile file = open("header\n" + std::string(bytes, 'x') + "end");
    ASSERT_TRUE(file.read_line());
    file.skip(bytes);
    EXPECT_EQ(file.remaining(), 3U);
    EXPECT_EQ(file.peek(9), "end");
  }
}

TEST_F(InputFileTest, TakesNoLineLongerThanAnyHeaders) {
  EXPECT_EQ(open(std::string(65536, 'x') + "\n").read_line()->size(), 65536U);
  InputFile file = open("one\n" + std::string(65537, 'x') + "\n");
  ASSERT_TRUE(file.read_line());
  EXPECT_TRUE(contains(message_of<Error>([&] { (void)file.read_line(); }),
                       "file, line 2: expected a header's line of at most 65536 bytes"));
}

TEST_F(InputFileTest, SaysSoWhereItBecameShorter) {
  InputFile file = open("0123456789");
  std::filesystem::resize_file(folder / "file", 4);
  std::array<char, 10> bytes{};
  EXPECT_TRUE(contains(message_of<Error>([&] { file.read(bytes.data(), 10); }),
                       "expected 10 bytes, got 4 (it became shorter while being read)"));
}

}  // namespace
}  // namespace groundgrid::io
