#include <span>

#include "cloud_invariants.hpp"
#include "io/bin_layout_guess.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using groundgrid::io::ScanFormat;
  groundgrid::fuzz::read_as(ScanFormat::kitti, bytes, size);
  groundgrid::fuzz::read_as(ScanFormat::nuscenes, bytes, size);
  for (const auto& layout : groundgrid::io::likely_layouts(std::as_bytes(std::span(bytes, size)),
                                                           groundgrid::io::kKittiLayout))
    groundgrid::fuzz::require(size % layout.bytes() == 0, "a likely layout gives whole points");
  return 0;
}
