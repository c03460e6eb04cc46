#include "io/scan_file.hpp"

#include <new>
#include <stdexcept>

#include "io/bin_scan.hpp"
#include "io/error.hpp"
#include "io/pcd.hpp"
#include "io/ply.hpp"

namespace groundgrid::io {
namespace {

void read(const std::filesystem::path& path, ScanFormat format, PointCloud& cloud) {
  switch (format) {
    case ScanFormat::kitti:
      return read_kitti_scan(path, cloud);
    case ScanFormat::nuscenes:
      return read_nuscenes_scan(path, cloud);
    case ScanFormat::pcd:
      return read_pcd(path, cloud);
    case ScanFormat::ply:
      return read_ply(path, cloud);
  }
}

}  // namespace

void read_scan(const std::filesystem::path& path, ScanFormat format, PointCloud& cloud) {
  cloud.clear();
  try {
    read(path, format, cloud);
  } catch (const std::bad_alloc&) {
    cloud.clear();
    throw Error({.file = path, .expected = "a scan that fits into memory", .got = "a larger one"});
  } catch (...) {
    cloud.clear();
    throw;
  }
}

}  // namespace groundgrid::io
