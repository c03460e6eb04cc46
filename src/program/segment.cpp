#include "program/segment.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "program/input_files.hpp"
#include "program/json_text.hpp"
#include "program/output_folder.hpp"
#include "program/progress_bar.hpp"
#include "program/run_record.hpp"
#include "program/segment_options.hpp"
#include "program/sequence_run.hpp"
#include "program/standard_output.hpp"
#include "program/timing_table.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kTiming = "timing.csv";
constexpr const char* kRecord = "run.json";

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
  Segmentation(const SegmentOptions& options, const Arguments& arguments)
      : options_(options),
        record_{.arguments = arguments,
                .input = options.input.path(),
                .output = options.output,
                .poses = options.input.pose_file(),
                .preset = options.method.preset(),
                .single_scan = options.method.single_scan(),
                .config = options.method.config(),
                .threads = options.method.threads()} {}

  void run() {
    options_.terrain.check();
    const auto sequences = options_.input.find_sequences();
    const bool single = options_.input.without_poses(sequences.front(), record_.single_scan);
    if (!std::exchange(record_.single_scan, single) && single)
      spdlog::info("{} has no poses: every file is taken as a single scan",
                   options_.input.path().string());
    std::vector<Job> jobs = jobs_for(sequences);
    // What cannot be written must show before anything is touched.
    check_outputs(sequences);
    const OutputFolder folder(options_.output);
    timing_.emplace(options_.output / kTiming);
    // A record of an earlier run must not vouch for the files of one that fails.
    remove_file(options_.output / kRecord);
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

  void check_outputs(const std::vector<io::ScanSequence>& sequences) const {
    InputFiles inputs;
    options_.input.add_files(inputs);
    options_.method.add_files(inputs);
    for (const io::ScanSequence& sequence : sequences) inputs.add(sequence);
    for (const char* const name : {kTiming, kRecord}) inputs.keep(options_.output / name);
    for (const io::ScanSequence& sequence : sequences) {
      ScanWriter(options_.output, sequence, cloud_output_named(options_.clouds)).check(inputs);
      if (options_.terrain.wanted())
        TerrainOutput::check(options_.output, sequence, record_.single_scan, inputs);
    }
  }

  void segment_all(std::vector<Job>& jobs) {
    const Clock::time_point begin = Clock::now();
    ProgressBar progress(scans_in(jobs));
    const RunContext context{options_, record_, *timing_, progress};
    for (Job& job : jobs) SequenceRun(context, job.sequence, std::move(job.poses)).run();
    record_.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }

  // After a failure: what went wrong first matters more than a second failure here.
  void keep_timing() const {
    try {
      timing_->write();
    } catch (const io::Error& error) {
      spdlog::warn("{}", error.what());
    }
  }

  void finish() const {
    timing_->write();
    if (record_.scans() == 0)
      throw io::Error({.file = options_.input.path(),
                       .expected = "at least one scan that can be segmented",
                       .got = fmt::format("none; all {} were skipped", record_.skipped())});
    if (record_.labelled() == 0)
      throw io::Error({.file = options_.input.path(),
                       .expected = "points in the map around the LiDAR",
                       .got = "none in any scan, so that all labels are unknown",
                       .remedy = "see what `groundgrid info` says of it"});
    if (record_.skipped() > 0)
      spdlog::warn("{} scans were skipped; run.json lists them", record_.skipped());
    spdlog::info("{:.1f} scans a second, with reading and writing", record_.scans_per_second());
    const std::string text = to_text(to_json(record_));
    io::write_text(options_.output / kRecord, text);
    if (options_.json) print_result(text);
  }

  const SegmentOptions& options_;
  RunRecord record_;
  std::optional<TimingTable> timing_;  ///< Read once no other run can change it.
};

}  // namespace

void add_segment(CLI::App& app, const Arguments& arguments) {
  CLI::App* const command = app.add_subcommand("segment", "Label every point of every scan");
  const auto options = std::make_shared<SegmentOptions>();
  options->add_to(*command);
  command->callback([options, arguments] { Segmentation(*options, arguments).run(); });
}

}  // namespace groundgrid::program
