#pragma once

#include <cstddef>
#include <vector>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Takes some fields of a cloud's records over into other records.
class FieldCopy {
 public:
  /// Adds the field of a cloud to the end of the records of another one, as one to take over.
  void add(const PointField& field, PointCloud& to);

  /// Takes the fields over for so many points. The records may be the same memory where no field
  /// comes to lie beyond its old place.
  void copy(const std::byte* from, std::size_t from_stride, std::byte* to, std::size_t to_stride,
            std::size_t points) const;

 private:
  struct Part {
    std::size_t from, to, bytes;
  };
  std::vector<Part> parts_;  ///< Fields that stay neighbours are one part.
};

/// Takes the fields that are called kPaddingName out of a cloud.
void drop_padding(PointCloud& cloud);

}  // namespace groundgrid::io
