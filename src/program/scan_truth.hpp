#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// The file of a scan's true labels: the one given, else the dataset's; empty where there is none.
std::filesystem::path truth_file(const io::ScanSequence& sequence, const io::ScanFile& scan,
                                 const std::filesystem::path& given);

/// Reads the true labels of a scan with so many points. Throws io::Error, with what to do, where
/// the file is missing, and as io::read_labels() does.
void read_truth(const std::filesystem::path& file, const io::ScanFile& scan, std::size_t points,
                std::vector<std::uint32_t>& truth);

}  // namespace groundgrid::program
