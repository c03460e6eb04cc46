#pragma once

#include <cstddef>
#include <filesystem>

#include "io/file_descriptor.hpp"

namespace groundgrid::io {

/// Makes a folder and those above it, so that a power failure does not take them away again.
/// Throws Error where that fails.
void make_folder(const std::filesystem::path& folder);

/// Has what was made, renamed and removed in a folder written to the disk. Throws Error where that
/// fails, but not where the file system knows of no such thing.
void sync_folder(const std::filesystem::path& folder);

/// Removes what killed runs left in a folder, but not in those below: files, and folders with what
/// is in them, that have names as HiddenFile gives them and that nobody holds locked. Returns how
/// many; passes over what cannot be removed.
std::size_t remove_leftovers(const std::filesystem::path& folder);

/// A folder that one run at a time writes to, of groundgrid or groundgrid-py, on this machine, in
/// another container or on another machine of the same share. The lock is the system's (flock), on
/// a file .groundgrid.lock in the folder, so that it goes with the run however that ends.
class FolderLock {
 public:
  /// The folder must be there. Throws Error where another run has it, or where the file system does
  /// not know locks.
  explicit FolderLock(const std::filesystem::path& folder);
  /// Removes the file, too.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock(FolderLock&&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  std::filesystem::path path_;
  FileDescriptor descriptor_;
};

}  // namespace groundgrid::io
