#pragma once

#include <filesystem>

namespace groundgrid::io {

/// Whether there is anything of that name, also a link that leads nowhere. False only where the
/// system says that there is nothing: what cannot be looked at (a loop of links, a folder without
/// rights) counts as there, so that opening it says what is wrong. Never throws a
/// filesystem_error.
bool is_there(const std::filesystem::path& path);

/// Whether a path is that of a directory, or of a link to one. Never throws a filesystem_error.
bool is_folder(const std::filesystem::path& path);

/// The folder that a file lies in, "." where its path names none.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Whether an open file is the one of that name, which is no link. Another one may have taken its
/// place since it was opened.
bool has_name(int open_file, const std::filesystem::path& path);

}  // namespace groundgrid::io
