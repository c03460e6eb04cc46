#include "program/reproduce.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "evaluation/label_record.hpp"
#include "evaluation/published_results.hpp"
#include "evaluation/reproduction.hpp"
#include "io/atomic_file.hpp"
#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "io/scan_sequence.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/input_files.hpp"
#include "program/interrupt.hpp"
#include "program/json_text.hpp"
#include "program/label_file.hpp"
#include "program/median.hpp"
#include "program/method_runner.hpp"
#include "program/scan_reading.hpp"
#include "program/standard_output.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using evaluation::ReproducedPreset;
using evaluation::Reproduction;
using evaluation::SequenceResult;

struct ReproduceOptions {
  fs::path dataset;
  std::vector<std::string> sequences;
  fs::path markdown;
  bool json = false;
};

int all_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

bool is_published(const io::ScanSequence& sequence) {
  const auto all = evaluation::published_sequences();
  return std::any_of(all.begin(), all.end(), [&](const evaluation::PublishedSequence& published) {
    return published.name == sequence.name;
  });
}

io::ScanPoses read_poses(const io::ScanSequence& sequence) {
  io::ScanPoses poses = io::ScanPoses::kitti(sequence.poses(), sequence.calibration());
  for (const io::ScanFile& scan : sequence.scans) (void)poses.pose(scan);
  return poses;
}

// Runs may take hours, so everything that can be missing is looked for before the first scan.
void require_labels_and_poses(const io::ScanSequence& sequence) {
  (void)read_poses(sequence);
  for (const io::ScanFile& scan : sequence.scans)
    if (!io::is_there(label_file(sequence.labels(), scan)))
      throw io::Error({.file = label_file(sequence.labels(), scan),
                       .expected = fmt::format("the labels of {}", scan.path.string()),
                       .got = "no such file"});
}

std::vector<io::ScanSequence> sequences_of_table(const ReproduceOptions& options) {
  std::vector<io::ScanSequence> sequences = io::find_sequences(options.dataset, options.sequences);
  std::erase_if(sequences, [&](const io::ScanSequence& sequence) {
    const bool in_table =
        is_published(sequence) && (!options.sequences.empty() || io::is_there(sequence.labels()));
    if (!in_table && !sequence.plain())
      spdlog::warn("sequence {} {} and is left out", sequence.name,
                   is_published(sequence) ? "has no labels" : "is not in the paper's Table I");
    return !in_table;
  });
  if (sequences.empty())
    throw io::Error({.file = options.dataset,
                     .expected = "a dataset with sequences/NN/velodyne and sequences/NN/labels, "
                                 "NN from 00 to 10",
                     .got = "no labelled sequence of the paper's Table I"});
  for (const io::ScanSequence& sequence : sequences) require_labels_and_poses(sequence);
  return sequences;
}

// What the method gave on one scan.
using ScanVisitor = std::function<void(const io::ScanFile&, const ScanSlot&)>;

void run_method(const Config& config, int threads, const io::ScanSequence& sequence,
                const ScanVisitor& visit) {
  MethodRunner runner(config, threads, read_poses(sequence));
  ScanSlot slot;
  // One after the other, so that nothing disturbs the times.
  for (const io::ScanFile& scan : sequence.scans) {
    check_interrupt();
    runner.read(scan, slot);
    runner.process(scan, slot);
    visit(scan, slot);
  }
}

// Milliseconds a scan, of all sequences.
struct Times {
  std::vector<double> one_thread;
  std::vector<double> all_threads;
};

void announce(const std::string& preset, const io::ScanSequence& sequence, int threads) {
  const std::size_t scans = sequence.scans.size();
  spdlog::info("preset {}, sequence {}, {} thread{}: {} scan{}", preset, sequence.name, threads,
               threads == 1 ? "" : "s", scans, scans == 1 ? "" : "s");
}

SequenceResult score(const std::string& preset, const Config& config,
                     const io::ScanSequence& sequence, evaluation::LabelRecord& labels,
                     Times& times) {
  announce(preset, sequence, 1);
  SequenceResult result{.name = sequence.name, .scans = sequence.scans.size()};
  std::vector<std::uint32_t> truth;
  std::vector<float> coordinates;
  run_method(config, 1, sequence, [&](const io::ScanFile& scan, const ScanSlot& processed) {
    io::read_labels(label_file(sequence.labels(), scan), scan.path, processed.labels.size(), truth);
    copy_coordinates(processed.points, coordinates);
    result.metrics.add_scan(coordinates, 3, truth, processed.labels);
    labels.add(processed.labels);
    times.one_thread.push_back(processed.milliseconds);
  });
  return result;
}

void repeat_with_all_threads(const std::string& preset, const Config& config,
                             const io::ScanSequence& sequence,
                             const evaluation::LabelRecord& labels, Times& times) {
  const int threads = all_threads();
  announce(preset, sequence, threads);
  std::size_t index = 0;
  run_method(config, threads, sequence, [&](const io::ScanFile& scan, const ScanSlot& processed) {
    if (!labels.holds(index++, processed.labels))
      throw std::runtime_error(
          fmt::format("{}: preset {} gives other labels with {} threads than with 1",
                      scan.path.string(), preset, threads));
    times.all_threads.push_back(processed.milliseconds);
  });
}

ReproducedPreset run_preset(const std::string& name, const Config& config,
                            const std::vector<io::ScanSequence>& sequences) {
  ReproducedPreset preset{.name = name};
  Times times;
  for (const io::ScanSequence& sequence : sequences) {
    evaluation::LabelRecord labels;
    preset.sequences.push_back(score(name, config, sequence, labels, times));
    repeat_with_all_threads(name, config, sequence, labels, times);
  }
  preset.one_thread_ms = median(std::move(times.one_thread));
  preset.all_threads_ms = median(std::move(times.all_threads));
  return preset;
}

std::string text_of(const ReproduceOptions& options, const Reproduction& reproduction) {
  if (!options.json) return evaluation::to_table(reproduction);
  nlohmann::ordered_json json = json_heading("reproduce");
  json["dataset"] = options.dataset.string();
  json.update(evaluation::to_json(reproduction));
  return to_text(json);
}

void reproduce(const ReproduceOptions& options) {
  const std::vector<io::ScanSequence> sequences = sequences_of_table(options);
  InputFiles inputs;
  for (const io::ScanSequence& sequence : sequences) inputs.add(sequence);
  inputs.keep(options.markdown);
  // Opened first: that it cannot be written must not show after hours.
  std::optional<io::AtomicFile> page;
  if (!options.markdown.empty()) page.emplace(options.markdown);
  const Reproduction reproduction{
      .title = fmt::format("GroundGrid {} on {}", version(), options.dataset.string()),
      .threads = static_cast<std::size_t>(all_threads()),
      .presets = {run_preset("paper", Config::paper(), sequences),
                  run_preset("default", Config{}, sequences)}};
  if (page) {
    page->write(evaluation::to_markdown(reproduction));
    page->commit();
  }
  print_result(text_of(options, reproduction));
}

}  // namespace

void add_reproduce(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "reproduce", "Repeat the paper's Table I on SemanticKITTI, beside its published figures");
  const auto options = std::make_shared<ReproduceOptions>();
  command->add_option("DATASET", options->dataset, "SemanticKITTI, or a part of it")->required();
  command->add_option("--sequence", options->sequences, "Only these sequences, of 00 to 10");
  command->add_option("--output-markdown", options->markdown, "Write the tables to this file too");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { reproduce(*options); });
}

}  // namespace groundgrid::program
