#include "program/render_scan.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/segmentation_metrics.hpp"
#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/input_options.hpp"
#include "program/interrupt.hpp"
#include "program/label_file.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/picture_options.hpp"
#include "program/point_groups.hpp"
#include "program/scan_choice.hpp"
#include "program/scan_reading.hpp"
#include "program/version.hpp"
#include "rendering/png_file.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

constexpr rendering::ImageSize kUsualSize{1200, 1000};

struct RenderScanOptions {
  InputOptions input;
  std::optional<std::size_t> number;
  PictureOptions picture;
  fs::path labels;
  fs::path truth;
  bool errors = false;
  double range_m = 50.0;
  MethodOptions method;
};

// All scans up to the chosen one, so that the map remembers what a drive has seen.
std::string run_method(const RenderScanOptions& options, const ChosenScan& chosen, ScanSlot& slot) {
  const bool single = options.input.without_poses(chosen.sequence, options.method.single_scan());
  MethodRunner runner(options.method.config(), options.input.read_poses(chosen.sequence, single),
                      {.R_level_lidar = options.input.R_level_lidar()});
  for (std::size_t i = single ? chosen.index : 0; i <= chosen.index; ++i) {
    check_interrupt();
    runner.read(chosen.sequence.scans[i], slot);
    runner.process(chosen.sequence.scans[i], slot);
  }
  return fmt::format(
      "GroundGrid {}, preset {}, {}", version(), options.method.preset(),
      single ? "a single scan" : fmt::format("after {} scans before it", chosen.index));
}

// Fills the slot; says where its labels are from.
std::string label_scan(const RenderScanOptions& options, const ChosenScan& chosen, ScanSlot& slot) {
  if (options.labels.empty()) return run_method(options, chosen, slot);
  read_into_slot(chosen.scan(), options.input.R_level_lidar(), slot);
  io::read_labels(options.labels, chosen.scan().path, slot.size(), slot.labels);
  return fmt::format("labels of {}", options.labels.string());
}

std::vector<std::uint32_t> read_truth(const RenderScanOptions& options, const ChosenScan& chosen,
                                      std::size_t points) {
  const fs::path file = options.truth.empty() && !chosen.sequence.plain()
                            ? label_file(chosen.sequence.labels(), chosen.scan())
                            : options.truth;
  if (file.empty() || !io::is_there(file))
    throw io::Error({.file = file.empty() ? chosen.scan().path : file,
                     .expected = "the true labels of the scan, for --errors",
                     .got = "none",
                     .remedy = "name them by --truth, or leave --errors out"});
  std::vector<std::uint32_t> truth;
  io::read_labels(file, chosen.scan().path, points, truth);
  return truth;
}

std::string score(std::span<const float> coordinates, std::span<const std::uint32_t> truth,
                  std::span<const std::uint32_t> labels) {
  evaluation::SegmentationMetrics metrics;
  metrics.add_scan(coordinates, 3, truth, labels);
  const evaluation::Confusion figures =
      metrics.total().confusion(evaluation::Unanswered::as_non_ground);
  return fmt::format("IoU {:.2f}, precision {:.2f}, recall {:.2f} %", 100.0 * figures.iou(),
                     100.0 * figures.precision(), 100.0 * figures.recall());
}

void render_scan(const RenderScanOptions& options) {
  options.picture.check();
  const ChosenScan chosen = choose_scan(options.input, options.number);
  ScanSlot slot;
  std::string caption = label_scan(options, chosen, slot);
  std::vector<float> coordinates;
  copy_coordinates(slot.points, coordinates);
  PointGroups groups;
  if (options.errors) {
    const std::vector<std::uint32_t> truth = read_truth(options, chosen, slot.size());
    groups = groups_by_error(truth, slot.labels);
    caption = score(coordinates, truth, slot.labels) + "; " + caption;
  } else {
    groups = groups_by_label(slot.labels);
  }
  const rendering::ScanPicture picture{.coordinates = coordinates,
                                       .group = groups.group,
                                       .styles = std::move(groups.styles),
                                       .range_m = options.range_m,
                                       .title = options.picture.title_or(chosen.words()),
                                       .caption = std::move(caption)};
  rendering::write_png(options.picture.output(),
                       rendering::draw_scan_from_above(picture, options.picture.size()));
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
  options->picture.add_to(*command, ".png", kUsualSize);
  CLI::Option* const labels = command->add_option(
      "--labels", options->labels, "Draw the labels of this file instead of running the method");
  CLI::Option* const errors = command->add_flag(
      "--errors", options->errors,
      "Draw what is right and wrong by the dataset's labels, or those of --truth");
  command->add_option("--truth", options->truth, "The true labels, for --errors")->needs(errors);
  command
      ->add_option("--range", options->range_m,
                   "Metres from the LiDAR to the nearest edge of the plot [50]")
      ->check(CLI::Range(1.0, 1000.0));
  options->method.add_to(*command);
  options->method.exclude(labels);
  command->callback([options] { render_scan(*options); });
}

}  // namespace groundgrid::program
