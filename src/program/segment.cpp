#include "program/segment.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/run_record.hpp"
#include "program/standard_output.hpp"
#include "program/timing_table.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

struct SegmentOptions {
  fs::path input;
  fs::path output;
  std::vector<std::string> sequences;
  bool keep_going = false;
  bool json = false;
  MethodOptions method;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw io::Error({.file = folder,
                     .expected = "a folder to write to",
                     .got = error.message(),
                     .remedy = "choose another --output"});
}

fs::path label_folder(const fs::path& output, const io::ScanSequence& sequence) {
  return sequence.plain() ? output : output / "sequences" / sequence.name / "predictions";
}

// A sequence and the poses to segment it with.
struct Job {
  io::ScanSequence sequence;
  std::optional<io::KittiPoses> poses;
};

// One run of `segment`: what is done is in the members, whether or not it comes to its end.
class Segmentation {
 public:
  explicit Segmentation(const SegmentOptions& options)
      : options_(options),
        record_{.input = options.input,
                .output = options.output,
                .preset = options.method.preset(),
                .single_scan = options.method.single_scan(),
                .config = options.method.config()},
        timing_(options.output / "timing.csv") {}

  void run() {
    const auto sequences = io::find_sequences(options_.input, options_.sequences);
    if (sequences.front().plain() && !std::exchange(record_.single_scan, true))
      spdlog::info("{} has no poses: every file is taken as a single scan",
                   options_.input.string());
    std::vector<Job> jobs = jobs_for(sequences);
    make_folder(options_.output);
    // A record of an earlier run must not vouch for the files of one that fails.
    fs::remove(options_.output / "run.json");
    try {
      for (Job& job : jobs) segment(job.sequence, std::move(job.poses));
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
        jobs.push_back({sequence, options_.keep_going
                                      ? read_poses(sequence, record_.single_scan)
                                      : read_every_pose(sequence, record_.single_scan)});
      } catch (const io::Error& error) {
        if (!options_.keep_going) throw;
        spdlog::warn("skipped sequence {}: {}", sequence.name, error.what());
        record_.skipped_sequences.push_back(
            {sequence.name, sequence.folder, sequence.scans.size(), error.what()});
      }
    }
    return jobs;
  }

  void segment(const io::ScanSequence& sequence, std::optional<io::KittiPoses> poses) {
    const fs::path folder = label_folder(options_.output, sequence);
    make_folder(folder);
    record_.sequences.push_back({.name = sequence.name, .folder = sequence.folder});
    SequenceRecord& record = record_.sequences.back();
    MethodRunner runner(record_.config, std::move(poses));
    for (const io::ScanFile& scan : sequence.scans) {
      check_interrupt();
      const auto processed = process(runner, scan, record);
      if (!processed) continue;
      io::write_labels(folder / (scan.name + ".label"), processed->labels);
      ++record.scans;
      record.counts.add(processed->result);
      timing_.add({record.name, scan.name, processed->labels.size(), processed->milliseconds});
    }
    record.notes = runner.notes();
    announce(record);
  }

  // Nothing where the scan is bad and to be passed over. Failing to write is never passed over.
  [[nodiscard]] std::optional<ProcessedScan> process(MethodRunner& runner, const io::ScanFile& scan,
                                                     SequenceRecord& record) const {
    try {
      return runner.process(scan);
    } catch (const io::Error& error) {
      if (!options_.keep_going) throw;
      spdlog::warn("skipped: {}", error.what());
      record.skipped.push_back({scan.path, error.what()});
      return std::nullopt;
    }
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
      throw io::Error({.file = options_.input,
                       .expected = "at least one scan that can be segmented",
                       .got = fmt::format("none; all {} were skipped", record_.skipped())});
    if (record_.skipped() > 0)
      spdlog::warn("{} scans were skipped; run.json lists them", record_.skipped());
    const std::string text = to_text(to_json(record_));
    io::write_text(options_.output / "run.json", text);
    if (options_.json) print_result(text);
  }

  const SegmentOptions& options_;
  RunRecord record_;
  TimingTable timing_;
};

}  // namespace

void add_segment(CLI::App& app) {
  CLI::App* const command = app.add_subcommand("segment", "Label every point of every scan");
  const auto options = std::make_shared<SegmentOptions>();
  command
      ->add_option("INPUT", options->input,
                   "Dataset in KITTI odometry layout, a folder of .bin files, or one .bin file")
      ->required();
  command->add_option("--output", options->output, "Folder to write to")->required();
  command->add_option("--sequence", options->sequences, "Only these sequences");
  command->add_flag("--keep-going", options->keep_going, "Skip bad scans and list them");
  command->add_flag("--json", options->json, "Print run.json to standard output, too");
  options->method.add_to(*command);
  command->callback([options] { Segmentation(*options).run(); });
}

}  // namespace groundgrid::program
