#pragma once

#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// Whether a path is that of a list of scans: a file .lst, or .txt that does not look like a cloud
/// (is_text_cloud()), in any case of letters.
bool is_scan_list(const std::filesystem::path& path);

/// One line of a list.
struct ListedFile {
  std::filesystem::path path;
  std::size_t line = 0;
};

/// Reads a list of files: the path of one a line, relative to the folder of the list; blank lines
/// and those that begin with '#' do not count. Throws Error, with the line, where a path is not
/// that of a regular file, and where there is none at all.
std::vector<ListedFile> read_scan_list(const std::filesystem::path& path);

}  // namespace groundgrid::io
