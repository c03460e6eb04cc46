#include "program/scan_painter.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <utility>
#include <vector>

#include "evaluation/segmentation_metrics.hpp"
#include "program/point_groups.hpp"
#include "program/scan_reading.hpp"
#include "rendering/scan_view.hpp"

namespace groundgrid::program {
namespace {

std::string score(std::span<const float> coordinates, std::span<const std::uint32_t> truth,
                  std::span<const std::uint32_t> labels) {
  evaluation::SegmentationMetrics metrics;
  metrics.add_scan(coordinates, 3, truth, labels);
  const evaluation::Confusion figures =
      metrics.total().confusion(evaluation::Unanswered::as_non_ground);
  return fmt::format("IoU {:.2f}, precision {:.2f}, recall {:.2f} %", 100.0 * figures.iou(),
                     100.0 * figures.precision(), 100.0 * figures.recall());
}

}  // namespace

CLI::Option* ScanLook::add_to(CLI::App& command) {
  view_.add_to(command, 0.0, 25.0);
  command
      .add_option("--range", range_m_,
                  "Metres from the LiDAR to the nearest edge of the plot from above [50]")
      ->check(CLI::Range(1.0, 1000.0));
  return command.add_flag("--errors", errors_,
                          "Draw what is right and wrong by the dataset's labels");
}

std::optional<double> height_in(const MethodNotes& notes) {
  if (!notes.sensor_heights) return std::nullopt;
  return notes.sensor_heights->greatest;
}

ScanPainter::ScanPainter(const ScanLook& look, rendering::ImageSize size)
    : look_(look),
      size_(size),
      renderer_(look.view().perspective() ? std::make_unique<rendering::PerspectiveRenderer>()
                                          : nullptr) {}

rendering::Palette ScanPainter::palette() const {
  const PointGroups groups = look_.errors() ? groups_by_error({}, {}) : groups_by_label({});
  std::vector<rendering::Color> colors;
  for (const rendering::PointStyle& style : groups.styles) colors.push_back(style.color);
  return rendering::Palette(colors);
}

rendering::Image ScanPainter::paint(const ScanSlot& slot, std::span<const std::uint32_t> truth,
                                    double sensor_height_m, ScanWords words) const {
  std::vector<float> coordinates;
  copy_coordinates(slot.points, coordinates);
  PointGroups groups =
      look_.errors() ? groups_by_error(truth, slot.labels) : groups_by_label(slot.labels);
  if (look_.errors()) words.caption = score(coordinates, truth, slot.labels) + "; " + words.caption;
  const rendering::ScanPicture picture{.coordinates = coordinates,
                                       .group = groups.group,
                                       .styles = std::move(groups.styles),
                                       .range_m = look_.range_m(),
                                       .sensor_height_m = sensor_height_m,
                                       .title = std::move(words.title),
                                       .caption = std::move(words.caption)};
  if (renderer_ == nullptr) return rendering::draw_scan_from_above(picture, size_);
  return rendering::draw_scan_in_perspective(*renderer_, picture, look_.view().point(), size_);
}

}  // namespace groundgrid::program
