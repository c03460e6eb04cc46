#pragma once

#include <filesystem>

#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// Where the labels of a scan are, in a folder of labels or predictions.
inline std::filesystem::path label_file(const std::filesystem::path& folder,
                                        const io::ScanFile& scan) {
  return folder / (scan.name + ".label");
}

}  // namespace groundgrid::program
