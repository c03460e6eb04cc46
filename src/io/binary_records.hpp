#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Throws Error if fewer bytes remain in the file than the points of a cloud take, whose fields and
/// shape are known.
void require_records(const InputFile& file, const PointCloud& cloud);

/// Reads the records of a cloud whose fields and shape are known, as they lie at the position of
/// the file. Throws Error where fewer points remain than the header promises.
void read_binary_records(InputFile& file, PointCloud& cloud);

/// Reverses the bytes of every number.
void swap_bytes(PointCloud& cloud);

}  // namespace groundgrid::io
