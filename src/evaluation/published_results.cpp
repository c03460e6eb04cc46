#include "evaluation/published_results.hpp"

namespace groundgrid::evaluation {
namespace {

constexpr std::array<PublishedSequence, kPublishedSequences> kSequences{{{"00", 4541},
                                                                         {"01", 1101},
                                                                         {"02", 4661},
                                                                         {"03", 801},
                                                                         {"04", 271},
                                                                         {"05", 2761},
                                                                         {"06", 1101},
                                                                         {"07", 1101},
                                                                         {"08", 4071},
                                                                         {"09", 1591},
                                                                         {"10", 1201}}};

using Percent = std::array<double, kPublishedSequences>;

constexpr PublishedRow row(std::string_view method, const Percent& sequences, double average) {
  return {method, sequences, average};
}

constexpr std::array kResults{
    PublishedMetric{
        "Precision",
        &Scores::precision,
        {row("Patchwork++",
             {94.99, 98.27, 95.96, 96.81, 98.18, 92.65, 97.86, 93.29, 96.97, 96.06, 92.81}, 95.80),
         row("GndNet",
             {92.40, 96.54, 93.74, 95.60, 97.30, 89.58, 96.15, 90.09, 95.09, 93.81, 88.34}, 93.51),
         row("JPC", {96.78, 97.97, 97.50, 98.09, 99.01, 94.03, 97.96, 95.65, 97.97, 97.64, 95.27},
             97.08),
         row("GroundGrid",
             {96.05, 98.01, 97.36, 97.96, 99.08, 95.19, 97.82, 95.31, 97.50, 97.25, 95.38},
             96.99)}},
    PublishedMetric{
        "Recall",
        &Scores::recall,
        {row("Patchwork++",
             {98.67, 96.52, 97.20, 98.17, 97.21, 98.13, 97.39, 98.42, 97.41, 96.45, 95.93}, 97.41),
         row("GndNet",
             {99.50, 96.91, 96.94, 96.68, 99.06, 98.69, 99.00, 99.44, 98.74, 96.14, 93.60}, 97.70),
         row("JPC", {97.20, 95.46, 93.72, 94.86, 96.91, 95.64, 96.23, 96.53, 95.13, 92.66, 88.47},
             94.97),
         row("GroundGrid",
             {98.70, 96.17, 97.71, 97.95, 97.85, 98.13, 98.38, 98.72, 97.79, 96.91, 95.90},
             97.65)}},
    PublishedMetric{
        "F1",
        &Scores::f1,
        {row("Patchwork++",
             {96.80, 97.39, 96.58, 97.49, 97.69, 95.31, 97.63, 95.79, 97.19, 96.25, 94.35}, 96.59),
         row("GndNet",
             {95.82, 96.72, 95.31, 96.14, 98.17, 93.91, 97.55, 94.53, 96.88, 94.96, 90.89}, 95.53),
         row("JPC", {96.99, 96.70, 95.57, 96.45, 97.95, 94.83, 97.09, 96.09, 96.53, 95.09, 91.74},
             95.91),
         row("GroundGrid",
             {97.35, 97.08, 97.54, 97.96, 98.46, 96.64, 98.10, 96.99, 97.64, 97.08, 95.64},
             97.32)}},
    PublishedMetric{
        "Accuracy",
        &Scores::accuracy,
        {row("Patchwork++",
             {96.64, 95.96, 95.08, 96.08, 96.39, 94.79, 96.63, 95.88, 96.37, 94.90, 93.75}, 95.68),
         row("GndNet",
             {95.53, 94.88, 93.20, 93.99, 97.10, 93.10, 96.46, 94.52, 95.91, 93.08, 89.81}, 94.33),
         row("JPC", {96.89, 94.93, 93.80, 94.59, 96.81, 94.37, 95.89, 96.26, 95.60, 93.50, 91.35},
             94.91),
         row("GroundGrid",
             {97.24, 95.50, 96.48, 96.84, 97.60, 96.32, 97.29, 97.08, 96.97, 96.05, 95.25},
             96.60)}},
    PublishedMetric{
        "IoU",
        &Scores::iou,
        {row("Patchwork++",
             {93.79, 94.90, 93.38, 95.09, 95.49, 91.04, 95.36, 91.91, 94.53, 92.78, 89.30}, 93.41),
         row("GndNet",
             {91.97, 93.65, 91.04, 92.55, 96.41, 88.52, 95.22, 89.63, 93.94, 90.41, 83.30}, 91.51),
         row("JPC", {94.15, 93.61, 91.52, 93.14, 95.98, 90.16, 94.34, 92.47, 93.29, 90.64, 84.75},
             92.19),
         row("GroundGrid",
             {94.84, 94.33, 95.19, 96.00, 96.97, 93.49, 96.27, 94.15, 95.40, 94.33, 91.64},
             94.78)}},
};

}  // namespace

std::span<const PublishedSequence, kPublishedSequences> published_sequences() { return kSequences; }

std::span<const PublishedMetric> published_results() { return kResults; }

}  // namespace groundgrid::evaluation
