#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// The name of PCD fields that only take up room, as often as the file likes.
inline constexpr const char* kPaddingName = "_";

/// Makes the fields of a header those of a scan: coordinates that are called X, Y, Z become x, y,
/// z. Throws Error, which lists the fields, where one of the three is missing or no single number,
/// or a name comes twice.
void name_coordinates(const std::filesystem::path& path, PointCloud& cloud);

}  // namespace groundgrid::io
