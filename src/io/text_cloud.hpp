#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads points as lines of text (.xyz, .pts, .csv, .txt) into a cleared cloud, every number as a
/// 64-bit float. Columns are separated by blanks, tabs, commas or semicolons. In front of the
/// points there may be comments ('#' or '//'), the number of points alone in a line, and the names
/// of the columns, which may be a comment. Without names the columns are x y z, then intensity or r
/// g b or both. Throws Error as read_scan says, and if there are other columns without names,
/// decimal commas, or fewer or more lines than the number says.
void read_text_cloud(const std::filesystem::path& path, PointCloud& cloud);

/// Whether a file of text looks like such a cloud: its first line that is no comment is of as many
/// numbers as a point without names may have, or names x, y and z. False also if it cannot be read.
bool is_text_cloud(const std::filesystem::path& path);

}  // namespace groundgrid::io
