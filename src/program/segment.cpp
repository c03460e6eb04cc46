#include "program/segment.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "program/input_options.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/output_folder.hpp"
#include "program/progress_bar.hpp"
#include "program/run_record.hpp"
#include "program/scan_pipeline.hpp"
#include "program/scan_writer.hpp"
#include "program/standard_output.hpp"
#include "program/terrain_output.hpp"
#include "program/timing_table.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct SegmentOptions {
  InputOptions input;
  fs::path output;
  std::string clouds = "none";
  bool keep_going = false;
  bool json = false;
  TerrainOptions terrain;
  MethodOptions method;
};

// A sequence and the poses to segment it with; none for single scans.
struct Job {
  io::ScanSequence sequence;
  std::optional<io::ScanPoses> poses;
};

std::size_t scans_in(const std::vector<Job>& jobs) {
  std::size_t scans = 0;
  for (const Job& job : jobs) scans += job.sequence.scans.size();
  return scans;
}

// One run of `segment`: what is done is in the members, whether or not it comes to its end.
class Segmentation {
 public:
  explicit Segmentation(const SegmentOptions& options)
      : options_(options),
        record_{.input = options.input.path(),
                .output = options.output,
                .poses = options.input.pose_file(),
                .preset = options.method.preset(),
                .single_scan = options.method.single_scan(),
                .config = options.method.config()},
        frames_{options.input.R_level_lidar(), options.terrain.T_map_poses()},
        crs_(options.terrain.crs()),
        timing_(options.output / "timing.csv") {}

  void run() {
    const auto sequences = options_.input.find_sequences();
    const bool single = options_.input.without_poses(sequences.front(), record_.single_scan);
    if (!std::exchange(record_.single_scan, single) && single)
      spdlog::info("{} has no poses: every file is taken as a single scan",
                   options_.input.path().string());
    std::vector<Job> jobs = jobs_for(sequences);
    make_folder(options_.output);
    // A record of an earlier run must not vouch for the files of one that fails.
    fs::remove(options_.output / "run.json");
    try {
      segment_all(jobs);
    } catch (...) {
      keep_timing();
      throw;
    }
    finish();
  }

 private:
  // All poses are read before the first scan, so that bad ones show at once.
  [[nodiscard]] std::vector<Job> jobs_for(const std::vector<io::ScanSequence>& sequences) {
    std::vector<Job> jobs;
    for (const io::ScanSequence& sequence : sequences) {
      try {
        // A scan without a pose is skipped alone where bad scans are to be skipped.
        jobs.push_back(
            {sequence, options_.keep_going
                           ? options_.input.read_poses(sequence, record_.single_scan)
                           : options_.input.read_every_pose(sequence, record_.single_scan)});
      } catch (const io::Error& error) {
        if (!options_.keep_going) throw;
        spdlog::warn("skipped sequence {}: {}", sequence.name, error.what());
        record_.skipped_sequences.push_back(
            {sequence.name, sequence.folder, sequence.scans.size(), error.what()});
      }
    }
    return jobs;
  }

  void segment_all(std::vector<Job>& jobs) {
    const Clock::time_point begin = Clock::now();
    ProgressBar progress(scans_in(jobs));
    for (Job& job : jobs) segment(job, progress);
    record_.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }

  void segment(Job& job, ProgressBar& progress) {
    const io::ScanSequence& sequence = job.sequence;
    const ScanWriter writer(options_.output, sequence, cloud_output_named(options_.clouds));
    std::optional<TerrainOutput> terrain;
    if (options_.terrain.wanted())
      terrain.emplace(options_.output, sequence, record_.single_scan, crs_);
    SequenceRecord& record = record_.sequences.emplace_back(
        SequenceRecord{.name = sequence.name, .folder = sequence.folder});
    MethodRunner runner(record_.config, std::move(job.poses), frames_);
    ScanPipeline().run(
        sequence.scans,
        {.read = [&](const io::ScanFile& scan, ScanSlot& slot) { runner.read(scan, slot); },
         .process =
             [&](const io::ScanFile& scan, ScanSlot& slot) {
               check_interrupt();
               if (!process(runner, scan, slot, record)) {
                 progress.advance();
                 return false;
               }
               if (terrain) terrain->add(scan, runner.terrain());
               return true;
             },
         .write = [&](const io::ScanFile& scan, ScanSlot& slot) { writer.write(scan, slot); },
         .done =
             [&](const io::ScanFile& scan, ScanSlot& slot) {
               ++record.scans;
               record.counts.add(slot.counts);
               timing_.add({record.name, scan.name, slot.size(), slot.milliseconds});
               progress.advance();
             }});
    if (terrain && record.scans > 0) {
      terrain->finish();
      record.terrain = terrain->place();
    }
    record.notes = runner.notes();
    announce(record);
  }

  // False where the scan is bad and to be passed over. Failing to write is never passed over.
  [[nodiscard]] bool process(MethodRunner& runner, const io::ScanFile& scan, ScanSlot& slot,
                             SequenceRecord& record) const {
    try {
      runner.process(scan, slot);
    } catch (const io::Error& error) {
      if (!options_.keep_going) throw;
      spdlog::warn("skipped: {}", error.what());
      record.skipped.push_back({scan.path, error.what()});
      return false;
    }
    return true;
  }

  static void announce(const SequenceRecord& record) {
    const std::string name = record.name.empty() ? "" : fmt::format("sequence {}: ", record.name);
    const std::string height = record.scans > 0 ? ", " + record.notes.sensor_words() : "";
    spdlog::info("{}segmented {} of {} scans{}", name, record.scans,
                 record.scans + record.skipped.size(), height);
  }

  // After a failure: what went wrong first matters more than a second failure here.
  void keep_timing() const {
    try {
      timing_.write();
    } catch (const io::Error& error) {
      spdlog::warn("{}", error.what());
    }
  }

  void finish() const {
    timing_.write();
    if (record_.scans() == 0)
      throw io::Error({.file = options_.input.path(),
                       .expected = "at least one scan that can be segmented",
                       .got = fmt::format("none; all {} were skipped", record_.skipped())});
    if (record_.skipped() > 0)
      spdlog::warn("{} scans were skipped; run.json lists them", record_.skipped());
    spdlog::info("{} scans in {:.1f} s, {:.1f} a second: reading, method and writing together",
                 record_.scans(), record_.seconds, record_.scans_per_second());
    const std::string text = to_text(to_json(record_));
    io::write_text(options_.output / "run.json", text);
    if (options_.json) print_result(text);
  }

  const SegmentOptions& options_;
  RunRecord record_;
  RunFrames frames_;
  std::string crs_;
  TimingTable timing_;
};

}  // namespace

void add_segment(CLI::App& app) {
  CLI::App* const command = app.add_subcommand("segment", "Label every point of every scan");
  const auto options = std::make_shared<SegmentOptions>();
  options->input.add_to(*command, "INPUT",
                        "Dataset in KITTI odometry layout, a folder of scans (.bin, .pcd.bin, "
                        ".pcd, .ply), one scan, or a list of scans (.txt, one path a line)");
  command->add_option("--output", options->output, "Folder to write to")->required();
  command
      ->add_option("--clouds", options->clouds,
                   "Write each cloud again with its labels and heights: same (as the input), pcd "
                   "or ply [none]")
      ->check(CLI::IsMember({"same", "pcd", "ply"}));
  options->terrain.add_to(*command);
  command->add_flag("--keep-going", options->keep_going, "Skip bad scans and list them");
  command->add_flag("--json", options->json, "Print run.json to standard output, too");
  options->method.add_to(*command);
  command->callback([options] { Segmentation(*options).run(); });
}

}  // namespace groundgrid::program
