#include "io/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "io/error.hpp"
#include "io/hidden_file.hpp"
#include "io/path_checks.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;

// The file of another run's lock may have gone between its opening and its locking.
FileDescriptor locked(const fs::path& path) {
  for (;;) {
    // A link would make a file in another place.
    FileDescriptor file = FileDescriptor::open(path, O_RDWR | O_CREAT | O_NOFOLLOW);
    if (!file.is_open()) fail_to_write(path, system_message(errno));
    if (::flock(file.get(), LOCK_EX | LOCK_NB) == 0) {
      if (has_name(file.get(), path)) return file;
      continue;
    }
    if (errno == EWOULDBLOCK)
      throw Error({.file = folder_of(path),
                   .expected = "a folder that no other run writes to",
                   .got = "one that is in use",
                   .remedy = "wait for the end of that run, or choose another folder"});
    throw Error({.file = path,
                 .expected = "a file that can be locked against other runs",
                 .got = system_message(errno),
                 .remedy = "choose a folder on another disk"});
  }
}

bool remove_leftover(const fs::path& path) {
  // To be locked on a share, files must be open for writing, which folders cannot be.
  FileDescriptor file = FileDescriptor::open(path, O_RDWR | O_NOFOLLOW | O_NONBLOCK);
  if (!file.is_open() && errno == EISDIR)
    file = FileDescriptor::open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  if (!file.is_open() || ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return false;
  std::error_code error;
  return fs::remove_all(path, error) > 0 && !error;
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path path = folder; !path.empty() && !is_there(path); path = path.parent_path())
    missing.push_back(path);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error({.file = folder,
                 .expected = "a folder to write to",
                 .got = error.message(),
                 .remedy = "choose another --output"});
  for (const fs::path& path : missing) sync_folder(folder_of(path));
}

void sync_folder(const fs::path& folder) {
  const FileDescriptor open_folder = FileDescriptor::open(folder, O_RDONLY | O_DIRECTORY);
  // A folder may be there to be written to and not to be read.
  if (!open_folder.is_open() && errno == EACCES) return;
  if (open_folder.is_open() && ::fsync(open_folder.get()) == 0) return;
  if (open_folder.is_open() && errno == EINVAL) return;
  fail_to_write(folder, system_message(errno));
}

std::size_t remove_leftovers(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
    if (is_hidden_name(entry->path().filename().string())) found.push_back(entry->path());
  std::size_t removed = 0;
  for (const fs::path& path : found)
    if (remove_leftover(path)) ++removed;
  return removed;
}

FolderLock::FolderLock(const fs::path& folder)
    : path_(folder / ".groundgrid.lock"), descriptor_(locked(path_)) {}

FolderLock::~FolderLock() { ::unlink(path_.c_str()); }

}  // namespace groundgrid::io
