#include "cloud_invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using groundgrid::io::ScanFormat;
  groundgrid::fuzz::read_as(ScanFormat::kitti, bytes, size);
  groundgrid::fuzz::read_as(ScanFormat::nuscenes, bytes, size);
  return 0;
}
