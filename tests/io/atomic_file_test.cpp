#include "io/atomic_file.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "support/limited_file_size.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::files_below;
using test::message_of;
using test::Names;
using test::read_file;

TEST(AtomicFile, AppearsOnlyWhenComplete) {
  const test::TemporaryFolder folder;
  AtomicFile file(folder / "a.txt");
  file.write("one ");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.write("two");
  file.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "one two");
  EXPECT_EQ(files_below(folder.path()), (Names{"a.txt"}));
}

TEST(AtomicFile, LeavesNothingWhenGivenUp) {
  const test::TemporaryFolder folder;
  {
    AtomicFile file(folder / "a.txt");
    file.write("half");
    EXPECT_EQ(files_below(folder.path()).size(), 1U);
  }
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(AtomicFile, ReplacesAFileOnlyWhenComplete) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.txt", "old");
  { AtomicFile(folder / "a.txt").write("half"); }
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  write_text(folder / "a.txt", "new");
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

TEST(AtomicFile, SaysThatAFolderIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<Error>([&] { AtomicFile file(folder / "none/a.txt"); }),
                       "none/a.txt: expected a place to write to, got No such file"));
}

TEST(AtomicFile, DoesNotReplaceAFolder) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a/b.txt", "kept");
  EXPECT_THROW(write_text(folder / "a", "new"), Error);
  EXPECT_EQ(files_below(folder.path()), (Names{"a/b.txt"}));
}

// Long texts fail when they are written, short ones when the file is closed.
class FullDisk : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FullDisk, IsNoticedAndLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.txt", "old");
  {
    const test::LimitedFileSize limit(100);
    EXPECT_TRUE(contains(
        message_of<Error>([&] { write_text(folder / "a.txt", std::string(GetParam(), 'x')); }),
        "a.txt: expected a place to write to, got File too large"));
  }
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(files_below(folder.path()), (Names{"a.txt"}));
}

INSTANTIATE_TEST_SUITE_P(Bytes, FullDisk, ::testing::Values(200U, 1'000'000U));

}  // namespace
}  // namespace groundgrid::io
