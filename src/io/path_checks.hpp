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

}  // namespace groundgrid::io
