#include "io/hidden_file.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::files_below;
using test::message_of;
using test::Names;
using test::read_file;

/// What fsync() is called for, and the call that fails; see below.
struct Syncs {
  std::vector<fs::path> paths{};
  std::size_t failing = 0;  ///< Counted from 1.
};
Syncs* syncs = nullptr;  // NOLINT(*-avoid-non-const-global-variables)

class SyncedFile : public ::testing::Test {
 protected:
  void SetUp() override { syncs = &called; }
  void TearDown() override { syncs = nullptr; }

  Syncs called;
  test::TemporaryFolder folder;
};

TEST(HiddenFile, HasAnotherNameEachTime) {
  const test::TemporaryFolder folder;
  const HiddenFile one(folder / "a.txt");
  const HiddenFile other(folder / "a.txt");
  EXPECT_NE(one.hidden(), other.hidden());
  EXPECT_TRUE(is_hidden_name(one.hidden().filename().string()));
  EXPECT_EQ(one.hidden().parent_path(), folder.path());
}

TEST(HiddenFile, KnowsItsOwnNamesOnly) {
  EXPECT_TRUE(is_hidden_name(".groundgrid-0123456789abcdef.tmp"));
  for (const char* const other :
       {".groundgrid-0123456789abcde.tmp", ".groundgrid-0123456789abcdeg.tmp",
        ".groundgrid-0123456789abcdef.tif", "groundgrid-0123456789abcdef.tmp", ".groundgrid.lock",
        ".a.txt.17.tmp", ".groundgrid-0123456789ABCDEF.tmp", ""})
    EXPECT_FALSE(is_hidden_name(other)) << other;
}

TEST(HiddenFile, DoesNotMixWithThatOfARunOfTheSameProcessNumber) {
  const test::TemporaryFolder folder;
  AtomicFile one(folder / "a.txt");
  AtomicFile other(folder / "a.txt");
  one.write("one");
  other.write("the other");
  one.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "one");
  other.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "the other");
  EXPECT_EQ(files_below(folder.path()), (Names{"a.txt"}));
}

TEST(HiddenFile, WritesThroughNoLinkThatSomebodyPutThere) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "other", "kept");
  const std::string guess = ".a.txt." + std::to_string(::getpid()) + ".tmp";
  fs::create_symlink(folder / "other", folder / guess);
  write_text(folder / "a.txt", "new");
  EXPECT_EQ(read_file(folder / "other"), "kept");
  EXPECT_FALSE(fs::is_symlink(folder / "a.txt"));
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

TEST(HiddenFile, IsNotCommittedOnceAnotherFileHasItsHiddenName) {
  const test::TemporaryFolder folder;
  HiddenFile file(folder / "a.txt");
  fs::remove(file.hidden());
  EXPECT_TRUE(contains(message_of<Error>([&] { file.commit(); }),
                       "a.txt: expected a place to write to, got another file, or none"));
  fs::create_symlink("/etc/passwd", file.hidden());
  EXPECT_THROW(file.commit(), Error);
  EXPECT_FALSE(fs::exists(folder / "a.txt"));
}

TEST(HiddenFile, HasTheRightsOfOtherFiles) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "other.txt", "");
  write_text(folder / "a.txt", "");
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(),
            fs::status(folder / "other.txt").permissions());
}

TEST_F(SyncedFile, IsOnTheDiskBeforeItHasItsNameAndThenItsFolderIs) {
  AtomicFile file(folder / "a.txt");
  file.write("whole");
  file.commit();
  ASSERT_EQ(called.paths.size(), 2U);
  EXPECT_TRUE(is_hidden_name(called.paths[0].filename().string())) << called.paths[0];
  EXPECT_EQ(called.paths[1], fs::canonical(folder.path()));
}

TEST_F(SyncedFile, IsOneOfManyThatWaitForTheDiskTogether) {
  FileBatch batch;
  for (const char* const name : {"a.txt", "b.txt"}) {
    AtomicFile file(folder / name);
    file.write("whole");
    batch.add(std::move(file));
    EXPECT_FALSE(fs::exists(folder / name));
  }
  EXPECT_TRUE(called.paths.empty());
  batch.commit();
  ASSERT_EQ(called.paths.size(), 3U);
  EXPECT_EQ(called.paths.back(), fs::canonical(folder.path())) << "once for both";
  EXPECT_EQ(files_below(folder.path()), (Names{"a.txt", "b.txt"}));
}

TEST_F(SyncedFile, IsLeftByNoBatchThatIsGivenUp) {
  {
    FileBatch batch;
    AtomicFile file(folder / "a.txt");
    batch.add(std::move(file));
  }
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST_F(SyncedFile, HasNoNameIfAnotherOneOfItsBatchIsLost) {
  called.failing = 2;
  FileBatch batch;
  for (const char* const name : {"a.txt", "b.txt"}) batch.add(AtomicFile(folder / name));
  EXPECT_TRUE(contains(message_of<Error>([&] { batch.commit(); }), "b.txt: expected a place"));
  EXPECT_EQ(files_below(folder.path()), Names{});
  batch.commit();
  EXPECT_EQ(files_below(folder.path()), Names{}) << "nothing is left to be named";
}

TEST_F(SyncedFile, DoesNotWaitForMoreThanAFewOthers) {
  FileBatch batch;
  for (int i = 0; i < 200; ++i) batch.add(AtomicFile(folder / std::to_string(i)));
  EXPECT_TRUE(fs::exists(folder / "100"));
  EXPECT_FALSE(fs::exists(folder / "199"));
  batch.commit();
  EXPECT_EQ(files_below(folder.path()).size(), 200U);
}

TEST_F(SyncedFile, IsNotThereIfItsBytesCannotBeKept) {
  called.failing = 1;
  EXPECT_TRUE(contains(message_of<Error>([&] { write_text(folder / "a.txt", "lost"); }),
                       "a.txt: expected a place to write to, got Input/output error"));
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST_F(SyncedFile, SaysThatItsNameCannotBeKept) {
  called.failing = 2;
  EXPECT_TRUE(
      contains(message_of<Error>([&] { write_text(folder / "a.txt", "new"); }),
               folder.path().string() + ": expected a place to write to, got Input/output"));
  EXPECT_EQ(files_below(folder.path()), (Names{"a.txt"}));
}

}  // namespace
}  // namespace groundgrid::io

// In place of the C library's.
extern "C" int fsync(int file) {
  using groundgrid::io::syncs;
  if (syncs != nullptr) {
    syncs->paths.push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file)));
    if (syncs->paths.size() == syncs->failing) {
      errno = EIO;
      return -1;
    }
  }
  return static_cast<int>(::syscall(SYS_fsync, file));
}
