#include "io/calibration.hpp"
#include "io/error.hpp"
#include "memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace groundgrid;
  const fuzz::MemoryFile file(bytes, size);
  try {
    const Eigen::Isometry3d mounting = io::read_lidar_calibration(file.path());
    const Eigen::Matrix3d rotation = mounting.linear();
    fuzz::require(rotation.isUnitary(1e-9) && rotation.determinant() > 0.0, "it is a rotation");
    fuzz::require(mounting.matrix().allFinite(), "all numbers are finite");
  } catch (const io::Error&) {  // A right answer too.
  }
  return 0;
}
