#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "evaluation/report.hpp"

namespace groundgrid::evaluation {

/// The labelled sequences of SemanticKITTI, which are the columns of Table I.
inline constexpr std::size_t kPublishedSequences = 11;

/// A sequence of SemanticKITTI and the scans that it has when nothing is missing.
struct PublishedSequence {
  std::string_view name;  ///< "00".
  std::size_t scans;
};

/// 00 to 10.
std::span<const PublishedSequence, kPublishedSequences> published_sequences();

/// One method's row in a block of Table I, percent.
struct PublishedRow {
  std::string_view method;
  std::array<double, kPublishedSequences> sequences;
  /// As printed. It is the mean of the row in all rows but one: JPC's recall has 94.97 where the
  /// mean is 94.80.
  double average;
};

/// One block of Table I: a figure of every method.
struct PublishedMetric {
  std::string_view name;   ///< "Precision".
  double Scores::*figure;  ///< The same figure of ours.
  std::array<PublishedRow, 4> rows;
};

/// Table I of the GroundGrid paper (Steinke, Goehring, Rojas, "GroundGrid: LiDAR Point Cloud Ground
/// Segmentation and Terrain Estimation", IEEE RA-L 2024, doi 10.1109/LRA.2023.3333233), "Ground
/// segmentation accuracy evaluation", in its order. The other methods were run by its authors.
std::span<const PublishedMetric> published_results();

/// Section IV-D of the same: the time of one scan of SemanticKITTI.
struct PublishedTime {
  double milliseconds = 5.85;
  double hertz = 171.0;
  std::string_view machine = "Intel i5-13600K, up to 8 threads";
};

}  // namespace groundgrid::evaluation
