#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "io/bin_layout.hpp"

namespace groundgrid::io {

/// The layouts that a .bin file may have by its numbers alone, among 3 to 6 32-bit floats and 3 or
/// 4 64-bit ones a point: one if they tell, several if they leave a choice, none if they are no
/// coordinates in any. Where the file has too few points, or all alike, it has the `usual` layout
/// that its name promises, if that fits.
///
/// A layout fits if the file is a whole number of points and their coordinates may be metres. Among
/// those that fit, the numbers tell by their sizes: heights, intensities and rings are each of a
/// kind, and a reader that goes astray mixes them.
std::vector<BinLayout> likely_layouts(std::span<const std::byte> file, const BinLayout& usual);

}  // namespace groundgrid::io
