#pragma once

#include <array>
#include <functional>
#include <span>

#include "io/scan_sequence.hpp"
#include "program/scan_slot.hpp"

namespace groundgrid::program {

/// What is done with each scan. `read` and `write` run on threads of their own, the others on the
/// caller's; each step sees the scans in their order.
struct PipelineSteps {
  using Step = std::function<void(const io::ScanFile&, ScanSlot&)>;

  /// Fills the slot; what it throws is kept in the slot as its problem.
  Step read{};
  /// False where the scan is to go no further.
  std::function<bool(const io::ScanFile&, ScanSlot&)> process{};
  /// Left out where nothing is written.
  Step write{};
  /// Once a scan is written.
  Step done{};
};

/// Runs the steps so that the next scan is read and the last one written while one is processed.
/// What a step throws ends the run after the scans before are written and done.
class ScanPipeline {
 public:
  void run(std::span<const io::ScanFile> scans, const PipelineSteps& steps);

 private:
  std::array<ScanSlot, 3> slots_;
};

}  // namespace groundgrid::program
