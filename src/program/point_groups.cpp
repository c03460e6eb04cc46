#include "program/point_groups.hpp"

#include <algorithm>
#include <stdexcept>

#include "evaluation/segmentation_metrics.hpp"
#include "evaluation/semantic_kitti_classes.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::program {
namespace {

using evaluation::Answer;
using evaluation::Truth;
using rendering::Color;

constexpr Color kUnknown{170, 170, 170};
constexpr Color kRightNonGround{150, 150, 150};
constexpr Color kNotCounted{214, 214, 214};

// In the order of their styles.
enum LabelGroup : std::uint8_t { unknown, ground, obstacle, outlier };
enum ErrorGroup : std::uint8_t {
  not_counted,
  true_negative,
  true_positive,
  false_negative,
  false_positive
};

std::uint8_t label_group(std::uint32_t label) {
  constexpr std::uint16_t kOutlier = 1;
  if (io::semantic_kitti_class(label) == kOutlier) return outlier;
  switch (evaluation::answer_of(label)) {
    case Answer::unanswered:
      return unknown;
    case Answer::ground:
      return ground;
    case Answer::non_ground:
      break;
  }
  return obstacle;
}

std::uint8_t error_group(std::uint32_t truth, std::uint32_t label) {
  const bool found = evaluation::answer_of(label) == Answer::ground;
  switch (evaluation::truth_of(io::semantic_kitti_class(truth))) {
    case Truth::ignored:
      return not_counted;
    case Truth::ground:
      return found ? true_positive : false_negative;
    case Truth::non_ground:
      break;
  }
  return found ? false_positive : true_negative;
}

}  // namespace

PointGroups groups_by_label(std::span<const std::uint32_t> labels) {
  constexpr double kOutlierSize = 2.0;
  PointGroups groups{
      .group = std::vector<std::uint8_t>(labels.size()),
      .styles = {{.name = "unknown", .color = kUnknown},
                 {.name = "ground", .color = rendering::kBluishGreen},
                 {.name = "obstacle", .color = rendering::kVermilion},
                 {.name = "outlier", .color = rendering::kBlack, .size = kOutlierSize}}};
  std::transform(labels.begin(), labels.end(), groups.group.begin(), label_group);
  return groups;
}

PointGroups groups_by_error(std::span<const std::uint32_t> truth,
                            std::span<const std::uint32_t> labels) {
  if (truth.size() != labels.size())
    throw std::invalid_argument("labels and their truth must be of the same length");
  constexpr double kErrorSize = 1.5;
  PointGroups groups{
      .group = std::vector<std::uint8_t>(labels.size()),
      .styles = {{.name = "not counted", .color = kNotCounted},
                 {.name = "true negative", .color = kRightNonGround},
                 {.name = "true positive", .color = rendering::kBluishGreen},
                 {.name = "false negative", .color = rendering::kBlue, .size = kErrorSize},
                 {.name = "false positive", .color = rendering::kVermilion, .size = kErrorSize}}};
  std::transform(truth.begin(), truth.end(), labels.begin(), groups.group.begin(), error_group);
  return groups;
}

}  // namespace groundgrid::program
