#include "cloud_invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  groundgrid::fuzz::read_as(groundgrid::io::ScanFormat::text, bytes, size);
  return 0;
}
