#include "io/scan_file.hpp"

#include <new>
#include <stdexcept>

#include "io/bin_scan.hpp"
#include "io/error.hpp"
#include "io/pcd.hpp"
#include "io/ply.hpp"
#include "io/text_cloud.hpp"

namespace groundgrid::io {
namespace {

void read(const std::filesystem::path& path, const ScanFormat& format, PointCloud& cloud) {
  switch (format.kind) {
    case ScanFormat::Kind::bin:
      return read_bin_scan(path, format.layout, cloud);
    case ScanFormat::Kind::pcd:
      return read_pcd(path, cloud);
    case ScanFormat::Kind::ply:
      return read_ply(path, cloud);
    case ScanFormat::Kind::text:
      return read_text_cloud(path, cloud);
  }
}

// Does so with an empty cloud that is empty again if that fails.
template <typename Read>
void fill(const std::filesystem::path& path, PointCloud& cloud, Read&& read_into) {
  cloud.clear();
  try {
    read_into(cloud);
  } catch (const std::bad_alloc&) {
    cloud.clear();
    throw Error({.file = path, .expected = "a scan that fits into memory", .got = "a larger one"});
  } catch (...) {
    cloud.clear();
    throw;
  }
}

}  // namespace

void read_scan(const std::filesystem::path& path, const ScanFormat& format, PointCloud& cloud) {
  fill(path, cloud, [&](PointCloud& empty) { read(path, format, empty); });
}

void read_scan(const ScanFile& scan, PointCloud& cloud) {
  if (!scan.layout_is_guessed) return read_scan(scan.path, scan.format, cloud);
  fill(scan.path, cloud,
       [&](PointCloud& empty) { read_bin_scan_if_likely(scan.path, scan.format.layout, empty); });
}

}  // namespace groundgrid::io
