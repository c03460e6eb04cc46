#include "program/render_drive.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "program/input_options.hpp"
#include "program/interrupt.hpp"
#include "program/method_options.hpp"
#include "program/method_runner.hpp"
#include "program/picture_options.hpp"
#include "program/progress_bar.hpp"
#include "program/scan_choice.hpp"
#include "program/scan_painter.hpp"
#include "program/scan_truth.hpp"
#include "program/usage_error.hpp"
#include "program/version.hpp"
#include "rendering/gif_file.hpp"

namespace groundgrid::program {
namespace {

constexpr rendering::ImageSize kUsualSize{800, 700};

// A GIF of more frames is hundreds of megabytes that no program plays.
constexpr std::size_t kMostFrames = 2000;

struct RenderDriveOptions {
  InputOptions input;
  PictureOptions picture;
  ScanLook look;
  std::string scans;
  std::size_t every = 1;
  double frames_per_second = 10.0;
  MethodOptions method;
};

/// Numbers of scans, both included.
struct ScanRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

ScanRange range_of(const std::string& text, const io::ScanSequence& sequence) {
  if (text.empty()) return {sequence.scans.front().number, sequence.scans.back().number};
  const std::size_t sign = text.find('-');
  if (sign != std::string::npos) {
    const auto first = number_in(std::string_view(text).substr(0, sign));
    const auto last = number_in(std::string_view(text).substr(sign + 1));
    if (first && last && *first <= *last) return {*first, *last};
  }
  throw UsageError(fmt::format("--scans: expected two numbers such as 100-250, got '{}'", text));
}

/// Which scans become frames, and which is the last that has to be read.
struct FramePlan {
  std::vector<bool> shown{};  ///< Of each scan of the sequence up to the last that is.
  std::size_t frames = 0;
};

FramePlan plan_frames(const RenderDriveOptions& options, const io::ScanSequence& sequence) {
  const ScanRange range = range_of(options.scans, sequence);
  FramePlan plan;
  std::size_t in_range = 0;
  for (std::size_t i = 0; i < sequence.scans.size(); ++i) {
    const std::size_t number = sequence.scans[i].number;
    if (number < range.first || number > range.last) continue;
    if (in_range++ % options.every != 0) continue;
    plan.shown.resize(i + 1, false);
    plan.shown[i] = true;
    ++plan.frames;
  }
  if (plan.frames == 0)
    throw io::Error(
        {.file = sequence.folder,
         .expected = fmt::format("scans with numbers {} to {}", range.first, range.last),
         .got = fmt::format("numbers {} to {}", sequence.scans.front().number,
                            sequence.scans.back().number)});
  if (plan.frames > kMostFrames)
    throw UsageError(
        fmt::format("{} frames are too many for a GIF, at most {}; choose some by "
                    "--every or --scans",
                    plan.frames, kMostFrames));
  return plan;
}

/// Runs over a drive and makes a frame of every scan that is to be shown.
class DriveFilm {
 public:
  DriveFilm(const RenderDriveOptions& options, const io::ScanSequence& sequence)
      : options_(options),
        sequence_(sequence),
        plan_(plan_frames(options, sequence)),
        single_(options.input.without_poses(sequence, options.method.single_scan())),
        runner_(options.method.config(), options.method.threads(),
                options.input.read_poses(sequence, single_),
                {.R_level_lidar = options.input.R_level_lidar()}),
        painter_(options.look, options.picture.size_or(kUsualSize)),
        gif_(options.picture.output(), options.picture.size_or(kUsualSize),
             options.frames_per_second, painter_.palette()) {}

  void make() {
    ProgressBar progress(plan_.shown.size());
    for (std::size_t i = 0; i < plan_.shown.size(); ++i) {
      check_interrupt();
      // Scans before the first frame are only there for the map to remember.
      if (plan_.shown[i] || !single_) process(sequence_.scans[i]);
      if (plan_.shown[i]) add_frame(i);
      progress.advance();
    }
    gif_.commit();
  }

 private:
  void process(const io::ScanFile& scan) {
    runner_.read(scan, slot_);
    runner_.process(scan, slot_);
  }

  void add_frame(std::size_t index) {
    const io::ScanFile& scan = sequence_.scans[index];
    if (options_.look.errors())
      read_truth(truth_file(sequence_, scan, {}), scan, slot_.size(), truth_);
    gif_.add(painter_.paint(
        slot_, truth_, height_in(runner_.notes()).value_or(kUsualSensorHeight_m),
        {options_.picture.title_or(words_of(sequence_, scan)),
         fmt::format("GroundGrid {}, preset {}", version(), options_.method.preset())}));
  }

  const RenderDriveOptions& options_;
  const io::ScanSequence& sequence_;
  FramePlan plan_;
  bool single_;
  MethodRunner runner_;
  ScanPainter painter_;
  rendering::GifFile gif_;
  ScanSlot slot_{};
  std::vector<std::uint32_t> truth_{};
};

void render_drive(const RenderDriveOptions& options) {
  options.picture.check();
  options.look.check();
  const io::ScanSequence sequence = only_sequence(options.input);
  InputFiles inputs;
  inputs.add(sequence);
  options.input.add_files(inputs);
  options.method.add_files(inputs);
  inputs.keep(options.picture.output());
  DriveFilm(options, sequence).make();
}

}  // namespace

void add_render_drive(CLI::App& render) {
  CLI::App* const command = render.add_subcommand(
      "drive", "The labelled scans of a drive one after another, as a GIF that moves along");
  const auto options = std::make_shared<RenderDriveOptions>();
  options->input.add_to(*command, "DATASET", "A dataset with --sequence, or a folder of scans");
  options->picture.add_to(*command, ".gif", "800x700");
  options->look.add_to(*command);
  command
      ->add_option("--scans", options->scans,
                   "Only scans with these numbers; the method runs over all before them, too [all]")
      ->type_name("A-B");
  command->add_option("--every", options->every, "Only every so manyth of them [1]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--fps", options->frames_per_second, "Frames a second [10]")
      ->check(CLI::Range(0.1, 50.0));
  options->method.add_to(*command);
  command->callback([options] { render_drive(*options); });
}

}  // namespace groundgrid::program
