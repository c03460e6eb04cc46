#pragma once

#include <filesystem>

#include "io/output_folder.hpp"

namespace groundgrid::program {

/// Makes a folder and those above it, and takes away what killed runs left in it. Throws io::Error
/// where it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// The folder that a run writes to: made, and locked against other runs as long as the object
/// lives, then freed of what killed ones left. Throws io::Error where another run has it.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& folder);

 private:
  io::FolderLock lock_;
};

/// Removes a file; none there is as well. Throws io::Error where that fails.
void remove_file(const std::filesystem::path& path);

}  // namespace groundgrid::program
