#include "program/render_scan.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/semantic_kitti_labels.hpp"
#include "program/input_options.hpp"
#include "program/interrupt.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/picture_options.hpp"
#include "program/scan_choice.hpp"
#include "program/scan_painter.hpp"
#include "program/scan_reading.hpp"
#include "program/scan_truth.hpp"
#include "program/version.hpp"
#include "rendering/png_file.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

constexpr rendering::ImageSize kUsualScanSize{1200, 1000};

struct RenderScanOptions {
  InputOptions input;
  std::optional<std::size_t> number;
  PictureOptions picture;
  ScanLook look;
  fs::path labels;
  fs::path truth;
  MethodOptions method;
};

/// A scan with its labels, and where these are from.
struct LabelledScan {
  ScanSlot slot{};
  std::string source{};
  std::optional<double> sensor_height_m{};
};

// All scans up to the chosen one, so that the map remembers what a drive has seen.
LabelledScan run_method(const RenderScanOptions& options, const ChosenScan& chosen) {
  const bool single = options.input.without_poses(chosen.sequence, options.method.single_scan());
  MethodRunner runner(options.method.config(), options.method.threads(),
                      options.input.read_poses(chosen.sequence, single),
                      {.R_level_lidar = options.input.R_level_lidar()});
  LabelledScan result;
  for (std::size_t i = single ? chosen.index : 0; i <= chosen.index; ++i) {
    check_interrupt();
    runner.read(chosen.sequence.scans[i], result.slot);
    runner.process(chosen.sequence.scans[i], result.slot);
  }
  result.sensor_height_m = height_in(runner.notes());
  result.source =
      fmt::format("GroundGrid {}, preset {}, {}", version(), options.method.preset(),
                  single ? "a single scan" : fmt::format("after {} scans before it", chosen.index));
  return result;
}

LabelledScan label_scan(const RenderScanOptions& options, const ChosenScan& chosen) {
  if (options.labels.empty()) return run_method(options, chosen);
  LabelledScan result{.source = fmt::format("labels of {}", options.labels.filename().string())};
  read_into_slot(chosen.scan(), options.input.R_level_lidar(), result.slot);
  io::read_labels(options.labels, chosen.scan().path, result.slot.size(), result.slot.labels);
  result.sensor_height_m = estimate_sensor_height(result.slot.points, Config{});
  return result;
}

void render_scan(const RenderScanOptions& options) {
  options.picture.check();
  options.look.check();
  const ChosenScan chosen = choose_scan(options.input, options.number);
  InputFiles inputs;
  inputs.add(chosen.sequence);
  for (const fs::path& file : {options.labels, options.truth}) inputs.add(file);
  options.input.add_files(inputs);
  options.method.add_files(inputs);
  inputs.keep(options.picture.output());
  const ScanPainter painter(options.look, options.picture.size_or(kUsualScanSize));
  const LabelledScan labelled = label_scan(options, chosen);
  std::vector<std::uint32_t> truth;
  if (options.look.errors())
    read_truth(truth_file(chosen.sequence, chosen.scan(), options.truth), chosen.scan(),
               labelled.slot.size(), truth);
  rendering::write_png(
      options.picture.output(),
      painter.paint(labelled.slot, truth, labelled.sensor_height_m.value_or(kUsualSensorHeight_m),
                    {options.picture.title_or(chosen.words()), labelled.source}));
}

}  // namespace

void add_render_scan(CLI::App& render) {
  CLI::App* const command =
      render.add_subcommand("scan", "A scan by its labels, or by the errors of these");
  const auto options = std::make_shared<RenderScanOptions>();
  options->input.add_to(*command, "SCAN", "A scan, or a dataset with --sequence and --scan");
  command->add_option(
      "--scan", options->number,
      "Number of the scan in the sequence; the method runs over all before it, too");
  options->picture.add_to(*command, ".png", "1200x1000");
  CLI::Option* const errors = options->look.add_to(*command);
  command->add_option("--truth", options->truth, "The true labels for --errors [the dataset's own]")
      ->needs(errors);
  CLI::Option* const labels = command->add_option(
      "--labels", options->labels, "Draw the labels of this file instead of running the method");
  options->method.add_to(*command);
  options->method.exclude(labels);
  command->callback([options] { render_scan(*options); });
}

}  // namespace groundgrid::program
