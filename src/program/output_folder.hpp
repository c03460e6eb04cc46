#pragma once

#include <filesystem>

#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// Makes a folder and those above it. Throws io::Error where that fails.
void make_folder(const std::filesystem::path& folder);

/// Removes a file; none there is as well. Throws io::Error where that fails.
void remove_file(const std::filesystem::path& path);

/// Throws UsageError where writing to `path` would overwrite the scan.
void require_other_file(const io::ScanFile& scan, const std::filesystem::path& path);

}  // namespace groundgrid::program
