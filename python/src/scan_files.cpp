#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "array_output.hpp"
#include "bindings.hpp"
#include "file_path.hpp"
#include "io/path_checks.hpp"
#include "io/pose_file.hpp"
#include "io/scan_file.hpp"
#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::python {
namespace {

namespace fs = std::filesystem;

std::optional<io::ScanFormat> format_named(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  const auto format = io::scan_format_named(*name);
  if (!format)
    throw nb::value_error(
        ("format: expected " + std::string(io::kFormatNames) + ", got '" + *name + "'").c_str());
  return format;
}

std::vector<io::ScanSequence> find_sequences(nb::handle input,
                                             const std::vector<std::string>& names,
                                             const std::optional<std::string>& format) {
  return io::find_sequences(path_from(input), names, format_named(format));
}

/// The bytes of all records, and the name, type, offset and count of every field in one.
nb::tuple read_records(const io::ScanFile& scan) {
  io::PointCloud cloud;
  {
    const nb::gil_scoped_release no_gil;
    io::read_scan(scan, cloud);
  }
  nb::list fields;
  for (const io::PointField& field : cloud.fields)
    fields.append(nb::make_tuple(field.name, std::string(io::name_of(field.type)), field.offset,
                                 field.count));
  std::vector<std::uint8_t> bytes(cloud.data.size());
  if (!bytes.empty()) std::memcpy(bytes.data(), cloud.data.data(), bytes.size());
  const std::size_t points = cloud.size();
  return nb::make_tuple(to_array(std::move(bytes), {points, cloud.stride_bytes}), fields);
}

/// Nothing where the sequence has no poses and none are given.
std::optional<std::vector<Eigen::Isometry3d>> poses_of(const io::ScanSequence& sequence,
                                                       const std::optional<fs::path>& poses,
                                                       const std::optional<fs::path>& calibration) {
  const bool has_own = !sequence.plain() && io::is_there(sequence.poses());
  if (!poses && !has_own) return std::nullopt;
  const io::ScanPoses all = poses ? io::ScanPoses::from_file(*poses, sequence, calibration)
                                  : io::ScanPoses::of_dataset(sequence);
  std::vector<Eigen::Isometry3d> found;
  for (const io::ScanFile& scan : sequence.scans) {
    if (!all.leaves_out(scan)) {
      found.push_back(all.pose(scan));
      continue;
    }
    found.emplace_back();
    found.back().matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return found;
}

nb::object read_poses(const io::ScanSequence& sequence, nb::handle poses, nb::handle calibration) {
  const auto path_if_given = [](nb::handle path) {
    return path.is_none() ? std::optional<fs::path>{} : path_from(path);
  };
  const auto found = poses_of(sequence, path_if_given(poses), path_if_given(calibration));
  return found ? to_array(std::span(*found)) : nb::none();
}

nb::tuple read_pose_file(nb::handle path) {
  io::PoseList list = io::read_pose_file(path_from(path));
  if (!list.numbers.empty())
    throw nb::value_error((path_from(path).string() +
                           ": expected a pose for every scan in turn, got poses for scans by their "
                           "numbers, which these scans have not")
                              .c_str());
  const std::size_t count = list.times.size();
  nb::object times = nb::none();
  if (count > 0) times = to_array(std::move(list.times), {count});
  return nb::make_tuple(to_array(std::span<const Eigen::Isometry3d>(list.poses)), times);
}

nb::object read_labels(const io::ScanSequence& sequence, const io::ScanFile& scan,
                       std::size_t points) {
  const fs::path file = sequence.labels() / (scan.name + ".label");
  if (sequence.plain() || !io::is_there(file)) return nb::none();
  std::vector<std::uint32_t> labels;
  io::read_labels(file, scan.path, points, labels);
  return to_array(std::move(labels), {points});
}

nb::list files_beside(const io::ScanSequence& sequence) {
  nb::list files;
  if (sequence.plain()) return files;
  for (const fs::path& file : {sequence.poses(), sequence.calibration(), sequence.times()})
    files.append(name_of_path(file));
  for (const io::ScanFile& scan : sequence.scans)
    files.append(name_of_path(sequence.labels() / (scan.name + ".label")));
  return files;
}

}  // namespace

void bind_scan_files(nb::module_& module) {
  nb::class_<io::ScanFile>(module, "ScanFile", "One scan on disk.")
      .def_prop_ro(
          "name", [](const io::ScanFile& self) { return name_of_path(self.name); },
          nb::for_getter(nb::sig("def name(self) -> str")), "The file's name without its ending.")
      .def_prop_ro(
          "path", [](const io::ScanFile& self) { return name_of_path(self.path); },
          nb::for_getter(nb::sig("def path(self) -> str")), "Where it is.")
      .def_prop_ro(
          "unusual_layout",
          [](const io::ScanFile& self) {
            return self.has_unusual_layout() ? io::name_of(self.format) : std::string();
          },
          nb::for_getter(nb::sig("def unusual_layout(self) -> str")),
          "The layout that the numbers of a .bin file told, if it is not that of its ending.");
  nb::class_<io::ScanSequence>(module, "ScanSequence", "Scans on disk that belong together.")
      .def_ro("name", &io::ScanSequence::name, "Of the sequence; empty outside of a dataset.")
      .def_ro("scans", &io::ScanSequence::scans, "In the order in which they were taken.")
      .def_prop_ro("beside", &files_beside,
                   nb::for_getter(nb::sig("def beside(self) -> list[str]")),
                   "What a dataset has beside the scans: poses, calibration, times and labels, "
                   "whether or not they are there.");
  module.def("find_sequences", &find_sequences, nb::arg("input"), nb::arg("names"),
             nb::arg("format").none(),
             nb::sig("def find_sequences(input: str | os.PathLike[str], names: list[str], format: "
                     "str | None) -> list[ScanSequence]"),
             "The sequences below a folder, or of a file or list.");
  module.def("read_records", &read_records, nb::arg("scan"),
             nb::sig("def read_records(scan: ScanFile) -> tuple[numpy.typing.NDArray[numpy.uint8], "
                     "list[tuple[str, str, int, int]]]"),
             "The records of a scan, one a row, and name, type, offset and count of their fields.");
  module.def("read_poses", &read_poses, nb::arg("sequence"), nb::arg("poses").none(),
             nb::arg("calibration").none(),
             nb::sig("def read_poses(sequence: ScanSequence, poses: str | os.PathLike[str] | None, "
                     "calibration: str | os.PathLike[str] | None) -> "
                     "numpy.typing.NDArray[numpy.float64] | None"),
             "T_map_lidar at each scan, NaN if the poses leave it out; None where there are no "
             "poses.");
  module.def("read_pose_file", &read_pose_file, nb::arg("path"),
             nb::sig("def read_pose_file(path: str | os.PathLike[str]) -> tuple["
                     "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64] | "
                     "None]"),
             "The poses of a file in KITTI's, TUM's or ASL's form, and their times, seconds, in "
             "the last two.");
  module.def("read_labels", &read_labels, nb::arg("sequence"), nb::arg("scan"), nb::arg("points"),
             nb::sig("def read_labels(sequence: ScanSequence, scan: ScanFile, points: int) -> "
                     "numpy.typing.NDArray[numpy.uint32] | None"),
             "The true labels of a scan of so many points; None where there are none.");
}

}  // namespace groundgrid::python
