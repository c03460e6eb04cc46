#include "io/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <memory>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/hidden_file.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::files_below;
using test::message_of;
using test::Names;

/// A process that has done something and then waits to be killed.
class WaitingProcess {
 public:
  explicit WaitingProcess(const std::function<void()>& before) {
    int ends[2] = {};
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      before();
      [[maybe_unused]] const auto told = ::write(ends[1], "x", 1);
      for (;;) ::pause();
    }
    ::close(ends[1]);
    char letter = 0;
    EXPECT_EQ(::read(ends[0], &letter, 1), 1);
    ::close(ends[0]);
  }
  ~WaitingProcess() { kill(); }
  WaitingProcess(const WaitingProcess&) = delete;
  WaitingProcess& operator=(const WaitingProcess&) = delete;
  WaitingProcess(WaitingProcess&&) = delete;
  WaitingProcess& operator=(WaitingProcess&&) = delete;

  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

TEST(FolderLock, RefusesAFolderThatIsInUse) {
  const test::TemporaryFolder folder;
  const FolderLock lock(folder.path());
  EXPECT_TRUE(contains(message_of<Error>([&] { const FolderLock other(folder.path()); }),
                       folder.path().string() +
                           ": expected a folder that no other run writes to, got one that is in "
                           "use; wait for the end of that run, or choose another folder"));
  const test::TemporaryFolder another;
  const FolderLock beside(another.path());
}

TEST(FolderLock, LeavesNothingBehind) {
  const test::TemporaryFolder folder;
  for (int run = 0; run < 3; ++run) {
    const FolderLock lock(folder.path());
    EXPECT_EQ(files_below(folder.path()), (Names{".groundgrid.lock"}));
  }
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(FolderLock, GoesWithAProcessThatIsKilled) {
  const test::TemporaryFolder folder;
  std::unique_ptr<FolderLock> lock;
  WaitingProcess other([&] { lock = std::make_unique<FolderLock>(folder.path()); });
  EXPECT_THROW(const FolderLock mine(folder.path()), Error);
  other.kill();
  EXPECT_EQ(files_below(folder.path()), (Names{".groundgrid.lock"}));
  { const FolderLock mine(folder.path()); }
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(FolderLock, MakesNoFileThroughALink) {
  const test::TemporaryFolder folder;
  fs::create_symlink("elsewhere", folder / ".groundgrid.lock");
  EXPECT_THROW(const FolderLock lock(folder.path()), Error);
  EXPECT_FALSE(fs::exists(folder / "elsewhere"));
}

TEST(FolderLock, NamesAFolderThatIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<Error>([&] { const FolderLock lock(folder / "none"); }),
                       "none/.groundgrid.lock: expected a place to write to, got No such file"));
}

TEST(Leftovers, AreRemovedOnceTheirProcessIsKilled) {
  const test::TemporaryFolder folder;
  std::unique_ptr<AtomicFile> file;
  WaitingProcess other([&] { file = std::make_unique<AtomicFile>(folder / "a.txt"); });
  EXPECT_EQ(remove_leftovers(folder.path()), 0U) << "that process may still go on";
  EXPECT_EQ(files_below(folder.path()).size(), 1U);
  other.kill();
  EXPECT_EQ(remove_leftovers(folder.path()), 1U);
  EXPECT_EQ(files_below(folder.path()), Names{});
}

TEST(Leftovers, AreFoldersToo) {
  const test::TemporaryFolder folder;
  test::write_file(folder / hidden_name() / "bag" / "half.mcap", "half");
  EXPECT_EQ(remove_leftovers(folder.path()), 1U);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Leftovers, AreNoFilesOfOthers) {
  const test::TemporaryFolder folder;
  const Names others{".a.txt.17.tmp", ".groundgrid-1234.tmp", "a.label",
                     "below/.groundgrid-0123456789abcdef.tmp"};
  for (const std::string& name : others) test::write_file(folder / name, "kept");
  EXPECT_EQ(remove_leftovers(folder.path()), 0U);
  EXPECT_EQ(files_below(folder.path()), others);
}

TEST(Leftovers, AreNoLinks) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a.txt", "kept");
  const std::string name = hidden_name();
  fs::create_symlink("a.txt", folder / name);
  EXPECT_EQ(remove_leftovers(folder.path()), 0U);
  EXPECT_TRUE(fs::is_symlink(folder / name));
  EXPECT_EQ(test::read_file(folder / "a.txt"), "kept");
}

TEST(MakeFolder, MakesThoseAboveItToo) {
  const test::TemporaryFolder folder;
  make_folder(folder / "a/b/c");
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  make_folder(folder / "a/b/c");
  make_folder(folder / "a/d/");
  EXPECT_TRUE(fs::is_directory(folder / "a/d"));
}

TEST(MakeFolder, NamesTheFolderThatCannotBe) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "a", "in the way");
  EXPECT_TRUE(contains(message_of<Error>([&] { make_folder(folder / "a/b"); }),
                       "a/b: expected a folder to write to, got Not a directory"));
}

}  // namespace
}  // namespace groundgrid::io
