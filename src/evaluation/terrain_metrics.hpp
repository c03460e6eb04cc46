#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/cell_lattice.hpp"
#include "evaluation/deviation_calibration.hpp"
#include "evaluation/terrain_errors.hpp"

namespace groundgrid::evaluation {

/// Points per m² that one scan has at least to have around a cell for it to be dense: the paper's
/// threshold (IV-C), 3 points a cell of 0.33 m.
inline constexpr double kDensePointsPerM2 = 27.0;

/// How far an unseen cell may be from a seen one for its height to be the estimate of a gap.
inline constexpr double kGap_m = 2.0;

/// Cells of which figures are wanted, whatever the reason: under vegetation, at kerbs.
struct TerrainMask {
  std::string name{};
  std::span<const float> values{};  ///< Neither 0 nor NaN: in the group.
};

/// A terrain and its reference over the same cells. NaN stands for no value.
struct TerrainLayers {
  CellLattice lattice{};
  std::span<const float> estimated_m{};
  std::span<const float> reference_m{};
  /// Greatest density of points that one scan had around the cell, 1/m². Empty where not known.
  std::span<const float> density{};
  /// Standard deviation that the estimate gives itself, metres. Empty where it gives none.
  std::span<const float> deviation_m{};
  /// Points in the cell over the drive. Empty where not known.
  std::span<const float> count{};
  /// Distance from the vehicle's path, metres. Empty where not known.
  std::span<const float> path_distance_m{};
  std::vector<TerrainMask> masks{};
};

/// Cells by how well the scans saw them.
struct ErrorsByDensity {
  TerrainErrors dense{};        ///< A scan had 27 points per m² or more around the cell.
  TerrainErrors sparse{};       ///< Some scan had points there, none so many.
  TerrainErrors unseen_near{};  ///< None had; a seen cell is at most kGap_m away.
  TerrainErrors unseen_far{};   ///< None had, and no seen cell is so near.
};

/// Cells with from <= value < to.
struct TerrainBin {
  double from = 0.0;
  double to = 0.0;  ///< Infinite in the last bin.
  TerrainErrors errors{};
};

/// Cells of a group whose estimates have a standard deviation.
struct GroupCalibration {
  std::string group{};
  DeviationCalibration figures{};
};

struct MaskErrors {
  std::string name{};
  TerrainErrors errors{};
};

/// Estimate less reference in the middle of all cells.
struct VerticalOffset {
  double median_m = 0.0;    ///< NaN where no cell is covered.
  std::uint64_t cells = 0;  ///< That it is the median of.
  bool of_dense = false;    ///< Of the dense cells; else of all, since none is known to be dense.
  bool taken_out = false;   ///< Whether the figures are those after it was subtracted.
};

struct TerrainFigures {
  std::uint64_t without_reference = 0;  ///< Cells with an estimate that nothing can judge.
  VerticalOffset offset{};
  TerrainErrors all{};
  std::optional<ErrorsByDensity> by_density{};
  /// What the paper takes: cells with at least 27 points per m², here over the whole drive.
  std::optional<TerrainErrors> paper{};
  /// The groups of density, where it is known, and all; empty where there are no deviations.
  std::vector<GroupCalibration> calibration{};
  std::vector<TerrainBin> by_path_distance{};  ///< Metres; empty where there is no path.
  std::vector<TerrainBin> by_slope{};          ///< Percent, of the reference.
  std::vector<MaskErrors> by_mask{};
};

/// What becomes of the vertical offset.
enum class OffsetUse : std::uint8_t { reported, taken_out };

/// Compares a terrain with its reference. Every group counts all its cells that have a reference
/// height, so that its coverage tells what was left out. Throws std::invalid_argument where a layer
/// has not one value a cell.
TerrainFigures compare_terrain(const TerrainLayers& layers, OffsetUse offset);

}  // namespace groundgrid::evaluation
