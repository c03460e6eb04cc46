#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "array_input.hpp"
#include "bindings.hpp"
#include "file_path.hpp"
#include "io/labelled_cloud.hpp"
#include "io/point_cloud.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::python {
namespace {

constexpr int kFieldTypes = 10;

io::FieldType field_type_named(const std::string& name) {
  for (int i = 0; i < kFieldTypes; ++i) {
    const auto type = static_cast<io::FieldType>(i);
    if (io::name_of(type) == name) return type;
  }
  throw nb::value_error(("fields: expected numbers such as float32, got " + name).c_str());
}

/// The records of a cloud, which lie one after the other.
io::PointCloud cloud_of(
    const std::vector<std::tuple<std::string, std::string, std::size_t>>& fields,
    nb::handle records) {
  io::PointCloud cloud;
  for (const auto& [name, type, count] : fields)
    cloud.add_field(name, field_type_named(type), count);
  const HeldBuffer bytes(records, "records");
  if (!bytes.holds('B') || bytes.dimensions() != 2 || bytes.length(1) != cloud.stride_bytes ||
      (bytes.length(0) > 0 &&
       (bytes.stride(1) != 1 || bytes.stride(0) != static_cast<std::ptrdiff_t>(bytes.length(1)))))
    throw nb::value_error("records: expected the packed bytes of the fields, one point a row");
  cloud.width = bytes.length(0);
  cloud.data.resize(cloud.width * cloud.stride_bytes);
  if (!cloud.data.empty()) std::memcpy(cloud.data.data(), bytes.data(), cloud.data.size());
  return cloud;
}

void write_cloud(nb::handle path, const std::string& format,
                 const std::vector<std::tuple<std::string, std::string, std::size_t>>& fields,
                 nb::handle records, nb::handle labels, nb::handle heights) {
  const auto known = io::scan_format_named(format);
  if (known != io::ScanFormat::pcd && known != io::ScanFormat::ply)
    throw nb::value_error(("format: expected 'pcd' or 'ply', got '" + format + "'").c_str());
  const io::PointCloud cloud = cloud_of(fields, records);
  const PackedArray classes = PackedArray::labels(labels, "labels");
  const PackedArray above = PackedArray::floats(heights, "heights");
  const std::filesystem::path file = path_from(path);
  const nb::gil_scoped_release no_gil;
  io::write_labelled_cloud(file, *known, cloud, classes.as_labels(), above.as_floats());
}

void write_labels(nb::handle path, nb::handle labels) {
  const PackedArray classes = PackedArray::labels(labels, "labels");
  const std::filesystem::path file = path_from(path);
  const nb::gil_scoped_release no_gil;
  io::write_labels(file, classes.as_labels());
}

}  // namespace

void bind_cloud_files(nb::module_& module) {
  module.def(
      "write_cloud", &write_cloud, nb::arg("path"), nb::arg("format"), nb::arg("fields"),
      nb::arg("records"), nb::arg("labels"), nb::arg("heights"),
      nb::sig("def write_cloud(path: str | os.PathLike[str], format: str, fields: "
              "list[tuple[str, str, int]], records: numpy.typing.NDArray[numpy.uint8], labels: "
              "numpy.typing.ArrayLike, heights: numpy.typing.ArrayLike) -> None"),
      "Writes records with fields of these names, types and counts, and behind them label and\n"
      "height_above_ground, as a PCD or PLY file; complete or not at all.");
  module.def(
      "write_labels", &write_labels, nb::arg("path"), nb::arg("labels"),
      nb::sig("def write_labels(path: str | os.PathLike[str], labels: "
              "numpy.typing.ArrayLike) -> None"),
      "Writes labels as SemanticKITTI has them, one uint32 a point; complete or not at all.");
}

}  // namespace groundgrid::python
