#pragma once

#include <filesystem>

namespace groundgrid::program {

/// Makes a folder and those above it. Throws io::Error where that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace groundgrid::program
