#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "groundgrid/scan.hpp"

namespace groundgrid::io {

/// How one number of a point lies in memory, in the machine's byte order.
enum class FieldType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
};

/// Bytes of one number.
std::size_t size_of(FieldType type);

/// "float32".
std::string_view name_of(FieldType type);

/// One field of every point: "x", "intensity", "ring", ...
struct PointField {
  std::string name;
  FieldType type = FieldType::float32;
  std::size_t offset = 0;  ///< Bytes from the beginning of a point's record.
  std::size_t count = 1;   ///< Numbers one after another; more than 1 in PCD histograms.

  [[nodiscard]] std::size_t bytes() const { return count * size_of(type); }
};

/// How a cloud's numbers were written, so that it can be written the same way again.
enum class CloudEncoding : std::uint8_t { ascii, binary, binary_big_endian, binary_compressed };

/// A point cloud with every field that its file had, as packed records in memory.
struct PointCloud {
  std::vector<PointField> fields{};
  std::size_t stride_bytes = 0;   ///< Of one record: no gaps between fields.
  std::size_t width = 0;          ///< Points a row.
  std::size_t height = 1;         ///< Rows; more than 1 in organised clouds (one a ring).
  std::vector<std::byte> data{};  ///< size() records, row by row.
  CloudEncoding encoding = CloudEncoding::binary;
  std::string viewpoint{};  ///< PCD's VIEWPOINT as written; empty where there is none.
  /// Bytes of a binary PCD or PLY file after all that its header promises: a sign that the header
  /// is wrong. 0 where further elements follow the vertices of a PLY file, since these are not
  /// read.
  std::size_t surplus_bytes = 0;

  [[nodiscard]] std::size_t size() const { return width * height; }

  /// The field of that name, or null.
  [[nodiscard]] const PointField* find(std::string_view name) const;

  /// Adds a field at the end of the records; its offset and the stride follow. Only while there
  /// are no data.
  void add_field(std::string name, FieldType type, std::size_t count = 1);

  /// Forgets points and fields, but keeps the memory.
  void clear();
};

/// One number of one point, as a double (64-bit integers beyond 2⁵³ are rounded).
double value_at(const PointCloud& cloud, std::size_t point, const PointField& field);

/// A view of a cloud's x, y and z for the method. Where they are 32-bit floats the view looks into
/// the cloud; else they are converted into `coordinates`, whose memory is reused. The view lives as
/// long as neither changes. The cloud must have the three fields, as every reader makes sure.
PointView point_view(const PointCloud& cloud, std::vector<float>& coordinates);

}  // namespace groundgrid::io
