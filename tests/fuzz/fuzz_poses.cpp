#include "io/error.hpp"
#include "io/scan_poses.hpp"
#include "memory_file.hpp"

namespace {

using namespace groundgrid;

template <typename Action>
void try_to(Action&& action) {
  try {
    action();
  } catch (const io::Error&) {  // A right answer too.
  }
}

void require_rotation(const Eigen::Isometry3d& pose) {
  fuzz::require(pose.linear().isUnitary(1e-9) && pose.linear().determinant() > 0.0,
                "a pose has a rotation");
}

io::ScanSequence two_scans() {
  io::ScanSequence sequence{"", "/nonexistent"};
  for (std::size_t i = 0; i < 2; ++i)
    sequence.scans.push_back({"", i, "scan.bin", io::ScanFormat::kitti, i});
  return sequence;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::MemoryFile calibration("Tr: 0 -1 0 0 0 0 -1 -0.08 1 0 0 -0.27\n");
  static const io::ScanSequence sequence = two_scans();
  const fuzz::MemoryFile file(bytes, size);
  try_to([&] {
    const auto poses = io::ScanPoses::kitti(file.path(), calibration.path());
    for (const io::ScanFile& scan : sequence.scans) require_rotation(poses.pose(scan));
  });
  try_to([&] {
    const auto poses = io::ScanPoses::from_file(file.path(), sequence);
    for (const io::ScanFile& scan : sequence.scans) require_rotation(poses.pose(scan));
  });
  try_to([&] {
    const io::PoseList list = io::read_pose_file(file.path());
    fuzz::require(list.times.empty() || list.times.size() == list.poses.size(),
                  "every pose has a time or none has");
  });
  try_to([&] { (void)io::read_scan_times(file.path()); });
  return 0;
}
