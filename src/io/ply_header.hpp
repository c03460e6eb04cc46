#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// A number of every record of an element, or a list of numbers with their count before them.
struct PlyProperty {
  std::string name;
  FieldType type = FieldType::float32;
  std::optional<FieldType> count_type{};  ///< Of a list only.
};

/// Records of one kind: vertices, faces, ...
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties{};

  [[nodiscard]] bool has_lists() const;
  /// Of the numbers of a record that are in no list.
  [[nodiscard]] std::size_t bytes() const;
};

struct PlyHeader {
  CloudEncoding encoding = CloudEncoding::ascii;
  std::vector<PlyElement> elements{};  ///< In the order of the file.
};

/// Reads the header of a PLY file. The file's position is then that of the first element. Throws
/// Error, with the line, where it is none.
PlyHeader read_ply_header(InputFile& file);

}  // namespace groundgrid::io
