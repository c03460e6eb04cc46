#pragma once

#include <optional>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "program/method_runner.hpp"
#include "program/progress_bar.hpp"
#include "program/run_record.hpp"
#include "program/scan_writer.hpp"
#include "program/segment_options.hpp"
#include "program/terrain_output.hpp"
#include "program/timing_table.hpp"

namespace groundgrid::program {

/// What the sequences of one run of `segment` share.
struct RunContext {
  const SegmentOptions& options;
  RunRecord& record;
  TimingTable& timing;
  ProgressBar& progress;
};

/// `segment` on one sequence: every scan read, labelled and written, and the terrain. What is done
/// stands in the run's record, whether or not it comes to its end.
class SequenceRun {
 public:
  /// Without poses every scan is a single one. Makes the folders. Throws io::Error, UsageError.
  SequenceRun(const RunContext& context, const io::ScanSequence& sequence,
              std::optional<io::ScanPoses> poses);

  /// Throws io::Error where a scan is bad and not to be skipped, or something cannot be written;
  /// std::runtime_error after an interrupt.
  void run();

 private:
  [[nodiscard]] bool process(const io::ScanFile& scan, ScanSlot& slot);
  void note_done(const io::ScanFile& scan, const ScanSlot& slot);
  void keep_written();
  void finish_terrain();
  void announce() const;
  void warn_of_little_ground() const;

  RunContext context_;
  const io::ScanSequence& sequence_;
  SequenceRecord& record_;
  MethodRunner runner_;
  ScanWriter writer_;
  std::optional<TerrainOutput> terrain_;
};

}  // namespace groundgrid::program
