#include "program/evaluate.hpp"

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

#include "evaluation/report.hpp"
#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "io/true_heights.hpp"
#include "program/input_options.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/label_file.hpp"
#include "program/median.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/progress_bar.hpp"
#include "program/scan_reading.hpp"
#include "program/standard_output.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using evaluation::Report;
using evaluation::SequenceResult;

struct EvaluateOptions {
  InputOptions input;
  fs::path predictions;
  bool leave_unanswered_out = false;
  bool json = false;
  bool csv = false;
  MethodOptions method;
};

std::size_t label_files_in(const fs::path& folder) {
  std::error_code unreadable;
  return static_cast<std::size_t>(std::count_if(
      fs::directory_iterator(folder, unreadable), fs::directory_iterator{},
      [](const fs::directory_entry& entry) { return entry.path().extension() == ".label"; }));
}

// Figures over a part of the scans would look like figures over all.
void require_label_files(const fs::path& folder, const io::ScanSequence& sequence) {
  for (const io::ScanFile& scan : sequence.scans)
    if (!io::is_there(label_file(folder, scan)))
      throw io::Error(
          {.file = label_file(folder, scan),
           .expected = fmt::format("labels for {}, as for each of the {} scans", scan.path.string(),
                                   sequence.scans.size()),
           .got = fmt::format("no such file ({} of them in the folder)", label_files_in(folder))});
}

std::vector<io::ScanSequence> labelled_sequences(const EvaluateOptions& options) {
  std::vector<io::ScanSequence> sequences = options.input.find_sequences();
  // The test sequences of SemanticKITTI have no labels; named ones must have them.
  if (!options.input.names_sequences())
    std::erase_if(sequences, [](const io::ScanSequence& sequence) {
      const bool unlabelled = !sequence.plain() && !io::is_there(sequence.labels());
      if (unlabelled) spdlog::warn("sequence {} has no labels and is left out", sequence.name);
      return unlabelled;
    });
  if (sequences.empty() || sequences.front().plain())
    throw io::Error({.file = options.input.path(),
                     .expected = "a dataset with sequences/NN/velodyne and sequences/NN/labels",
                     .got = "no labelled sequence"});
  for (const io::ScanSequence& sequence : sequences)
    require_label_files(sequence.labels(), sequence);
  return sequences;
}

/// What is true of one scan after another of a sequence.
class SequenceTruth {
 public:
  explicit SequenceTruth(const io::ScanSequence& sequence)
      : labels_folder_(sequence.labels()),
        heights_folder_(sequence.true_heights()),
        has_heights_(io::is_folder(heights_folder_)) {}

  void read(const io::ScanFile& scan, std::size_t points) {
    io::read_labels(label_file(labels_folder_, scan), scan.path, points, labels_);
    if (has_heights_)
      io::read_true_heights(heights_folder_ / (scan.name + ".f32"), scan.path, points, heights_);
  }

  void count(const ScanSlot& slot, SequenceResult& figures) {
    copy_coordinates(slot.points, coordinates_);
    figures.metrics.add_scan(coordinates_, 3, labels_, slot.labels, heights_);
  }

 private:
  fs::path labels_folder_;
  fs::path heights_folder_;
  bool has_heights_;
  std::vector<std::uint32_t> labels_;
  std::vector<float> heights_;
  std::vector<float> coordinates_;
};

struct Evaluation {
  Report report;
  std::vector<MethodNotes> notes;  ///< Of each sequence; none where predictions were read.
};

SequenceResult run_method(MethodRunner runner, const io::ScanSequence& sequence, MethodNotes& notes,
                          ProgressBar& progress) {
  SequenceResult figures{.name = sequence.name, .scans = sequence.scans.size()};
  SequenceTruth truth(sequence);
  std::vector<double> milliseconds;
  ScanSlot slot;
  // One after the other, so that nothing disturbs the times.
  for (const io::ScanFile& scan : sequence.scans) {
    check_interrupt();
    runner.read(scan, slot);
    runner.process(scan, slot);
    truth.read(scan, slot.size());
    truth.count(slot, figures);
    milliseconds.push_back(slot.milliseconds);
    progress.advance();
  }
  figures.median_ms = median(std::move(milliseconds));
  notes = runner.notes();
  spdlog::info("sequence {}: {}", sequence.name, notes.sensor_words());
  return figures;
}

std::size_t scans_in(const std::vector<io::ScanSequence>& sequences) {
  std::size_t scans = 0;
  for (const io::ScanSequence& sequence : sequences) scans += sequence.scans.size();
  return scans;
}

void run_method_on_all(const EvaluateOptions& options, const Config& config,
                       const std::vector<io::ScanSequence>& sequences, Evaluation& result) {
  // All poses are read before the first scan, so that bad ones show at once.
  std::vector<std::optional<io::ScanPoses>> poses;
  poses.reserve(sequences.size());
  for (const io::ScanSequence& sequence : sequences)
    poses.push_back(options.input.read_every_pose(sequence, options.method.single_scan()));
  const RunFrames frames{.R_level_lidar = options.input.R_level_lidar()};
  ProgressBar progress(scans_in(sequences));
  for (std::size_t i = 0; i < sequences.size(); ++i)
    result.report.sequences.push_back(
        run_method(MethodRunner(config, options.method.threads(), std::move(poses[i]), frames),
                   sequences[i], result.notes.emplace_back(), progress));
}

SequenceResult read_predictions(const EvaluateOptions& options, const io::ScanSequence& sequence) {
  const fs::path folder = options.predictions / "sequences" / sequence.name / "predictions";
  require_label_files(folder, sequence);
  if (const std::size_t files = label_files_in(folder); files != sequence.scans.size())
    spdlog::warn("{} holds {} label files, but only {} have a scan", folder.string(), files,
                 sequence.scans.size());
  SequenceResult figures{.name = sequence.name, .scans = sequence.scans.size()};
  ScanSlot slot;
  SequenceTruth truth(sequence);
  for (const io::ScanFile& scan : sequence.scans) {
    check_interrupt();
    read_into_slot(scan, Eigen::Matrix3d::Identity(), slot);
    truth.read(scan, slot.size());
    io::read_labels(label_file(folder, scan), scan.path, slot.size(), slot.labels);
    truth.count(slot, figures);
  }
  return figures;
}

std::string title_of(const EvaluateOptions& options) {
  if (!options.predictions.empty())
    return fmt::format("Predictions in {} against {}", options.predictions.string(),
                       options.input.path().string());
  return fmt::format(
      "GroundGrid {}, preset {}, {}, {} thread{}, on {}", version(), options.method.preset(),
      options.method.single_scan() ? "single scans" : "sequences with poses",
      options.method.threads() == 0 ? "all" : std::to_string(options.method.threads()),
      options.method.threads() == 1 ? "" : "s", options.input.path().string());
}

void print_report(const EvaluateOptions& options, const Arguments& arguments, const Config& config,
                  const Evaluation& result) {
  const Report& report = result.report;
  if (options.csv) return print_result(evaluation::to_csv(report));
  if (!options.json) return print_result(evaluation::to_table(report));
  nlohmann::ordered_json json = json_heading("evaluate");
  json["arguments"] = arguments;
  json.update(evaluation::to_json(report));
  for (std::size_t i = 0; i < result.notes.size(); ++i)
    put_notes(json["sequences"][i], result.notes[i]);
  if (options.predictions.empty()) {
    json["preset"] = options.method.preset();
    json["single_scan"] = options.method.single_scan();
    json["config"] = to_json(config);
  }
  print_result(to_text(json));
}

void evaluate(const EvaluateOptions& options, const Arguments& arguments) {
  const Config config = options.method.config();
  const std::vector<io::ScanSequence> sequences = labelled_sequences(options);
  Evaluation result{.report = {.title = title_of(options),
                               .unanswered = options.leave_unanswered_out
                                                 ? evaluation::Unanswered::left_out
                                                 : evaluation::Unanswered::as_non_ground},
                    .notes = {}};
  if (options.predictions.empty())
    run_method_on_all(options, config, sequences, result);
  else
    for (const io::ScanSequence& sequence : sequences)
      result.report.sequences.push_back(read_predictions(options, sequence));
  print_report(options, arguments, config, result);
}

}  // namespace

void add_evaluate(CLI::App& app, const Arguments& arguments) {
  CLI::App* const command =
      app.add_subcommand("evaluate", "Score the method, or predictions, on labelled scans");
  const auto options = std::make_shared<EvaluateOptions>();
  options->input.add_to(*command, "DATASET", "Dataset in SemanticKITTI layout");
  CLI::Option* const predictions =
      command->add_option("--predictions", options->predictions,
                          "Score DIR/sequences/NN/predictions instead of running the method");
  command->add_flag("--leave-unanswered-out", options->leave_unanswered_out,
                    "Count points without an answer nowhere, instead of as non-ground");
  CLI::Option* const json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--csv", options->csv, "Print CSV")->excludes(json);
  options->method.add_to(*command);
  options->method.exclude(predictions);
  options->input.exclude_poses(predictions);
  command->callback([options, arguments] { evaluate(*options, arguments); });
}

}  // namespace groundgrid::program
