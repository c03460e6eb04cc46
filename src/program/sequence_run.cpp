#include "program/sequence_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <utility>

#include "io/error.hpp"
#include "program/interrupt.hpp"
#include "program/scan_pipeline.hpp"

namespace groundgrid::program {

SequenceRun::SequenceRun(const RunContext& context, const io::ScanSequence& sequence,
                         std::optional<io::ScanPoses> poses)
    : context_(context),
      sequence_(sequence),
      record_(context.record.sequences.emplace_back(
          SequenceRecord{.name = sequence.name, .folder = sequence.folder})),
      runner_(context.record.config, context.options.method.threads(), std::move(poses),
              {.R_level_lidar = context.options.input.R_level_lidar(),
               .T_map_level = context.options.terrain.T_map_level()}),
      writer_(context.options.output, sequence, cloud_output_named(context.options.clouds)) {
  writer_.make_folders();
  if (context.options.terrain.wanted())
    terrain_.emplace(context.options.output, sequence, context.record.single_scan,
                     context.options.terrain);
  if (writer_.writes_clouds()) runner_.keep_heights();
  if (context.options.terrain.layers_wanted())
    runner_.make_layers(context.options.terrain.limits());
}

void SequenceRun::run() {
  const PipelineSteps steps{
      .read = [this](const io::ScanFile& scan, ScanSlot& slot) { runner_.read(scan, slot); },
      .process = [this](const io::ScanFile& scan, ScanSlot& slot) { return process(scan, slot); },
      .write = [this](const io::ScanFile& scan, ScanSlot& slot) { writer_.write(scan, slot); },
      .done = [this](const io::ScanFile& scan, ScanSlot& slot) { note_done(scan, slot); }};
  try {
    ScanPipeline().run(sequence_.scans, steps);
  } catch (...) {
    keep_written();
    throw;
  }
  writer_.finish();
  if (terrain_ && record_.scans > 0) finish_terrain();
  record_.notes = runner_.notes();
  announce();
}

// False where the scan is bad and to be passed over. Failing to write is never passed over.
bool SequenceRun::process(const io::ScanFile& scan, ScanSlot& slot) {
  check_interrupt();
  try {
    runner_.process(scan, slot);
  } catch (const io::Error& error) {
    if (!context_.options.keep_going) throw;
    spdlog::warn("skipped: {}", error.what());
    record_.skipped.push_back({scan.path, error.what()});
    context_.progress.advance();
    return false;
  }
  if (terrain_ && !runner_.is_lone(scan)) terrain_->add(scan, runner_.terrain(), runner_.layers());
  return true;
}

void SequenceRun::note_done(const io::ScanFile& scan, const ScanSlot& slot) {
  ++record_.scans;
  record_.counts.add(slot.counts);
  context_.timing.add({record_.name, scan.name, slot.size(), slot.milliseconds});
  context_.progress.advance();
}

// After a failure: what went wrong first matters more than a second failure here.
void SequenceRun::keep_written() {
  try {
    writer_.finish();
  } catch (const io::Error& error) {
    spdlog::warn("{}", error.what());
  }
}

void SequenceRun::finish_terrain() {
  try {
    if (terrain_->finish()) record_.terrain = terrain_->place();
  } catch (const io::Error& error) {
    if (!context_.options.keep_going) throw;
    spdlog::warn("{}", error.what());
  }
}

void SequenceRun::announce() const {
  const std::string name = record_.name.empty() ? "" : fmt::format("sequence {}: ", record_.name);
  const std::string height = record_.scans > 0 ? ", " + record_.notes.sensor_words() : "";
  if (record_.notes.without_pose > 0)
    spdlog::warn(
        "{}{} scans have no pose: they are segmented as single scans and are not in the terrain",
        name, record_.notes.without_pose);
  warn_of_little_ground();
  spdlog::info("{}segmented {} of {} scans{}", name, record_.scans,
               record_.scans + record_.skipped.size(), height);
}

void SequenceRun::warn_of_little_ground() const {
  constexpr double kLittle_percent = 1.0;
  const LabelCounts& counts = record_.counts;
  const std::size_t labelled = counts.points() - counts.unknown;
  const double percent = 100.0 * static_cast<double>(counts.ground) /
                         static_cast<double>(std::max<std::size_t>(labelled, 1));
  if (labelled > 0 && percent < kLittle_percent)
    spdlog::warn(
        "{}: only {:.1f} % of the labelled points are ground: is z up, is the LiDAR level "
        "(--lidar-rpy-deg), is its height right (--sensor-height-m)?",
        sequence_.folder.string(), percent);
}

}  // namespace groundgrid::program
