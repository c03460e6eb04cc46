#include <vector>

#include "io/error.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "memory_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace groundgrid;
  const fuzz::MemoryFile file(bytes, size);
  // As many points as there may be labels, and one point whatever there is.
  for (const std::size_t points : {size / sizeof(std::uint32_t), std::size_t{1}}) {
    std::vector<std::uint32_t> labels;
    try {
      io::read_labels(file.path(), "scan.bin", points, labels);
      fuzz::require(labels.size() == points, "there is a label for each point");
    } catch (const io::Error&) {
      fuzz::require(size != points * sizeof(std::uint32_t), "a file of the right size is read");
    }
  }
  return 0;
}
