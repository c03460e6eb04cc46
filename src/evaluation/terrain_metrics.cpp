#include "evaluation/terrain_metrics.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "evaluation/cell_distance.hpp"
#include "evaluation/slope.hpp"

namespace groundgrid::evaluation {
namespace {

constexpr std::array<double, 5> kPathDistances_m{0.0, 5.0, 10.0, 20.0, 40.0};
constexpr std::array<const char*, 4> kDensityGroups{"dense", "sparse", "unseen_near", "unseen_far"};
constexpr std::array<double, 5> kSlopes_percent{0.0, 5.0, 15.0, 30.0, 50.0};

void check_layers(const TerrainLayers& layers) {
  const std::size_t cells = layers.lattice.cells();
  const auto fits = [cells](std::span<const float> layer) { return layer.size() == cells; };
  const auto fits_if_known = [&](std::span<const float> layer) {
    return layer.empty() || fits(layer);
  };
  bool all_fit = fits(layers.estimated_m) && fits(layers.reference_m) &&
                 fits_if_known(layers.density) && fits_if_known(layers.count) &&
                 fits_if_known(layers.deviation_m) && fits_if_known(layers.path_distance_m);
  for (const TerrainMask& mask : layers.masks) all_fit = all_fit && fits(mask.values);
  if (!all_fit) throw std::invalid_argument("every layer must have one value a cell");
}

/// The comparison of one pair of surfaces.
class Comparison {
 public:
  Comparison(const TerrainLayers& layers, OffsetUse use) : layers_(layers) {
    offset_ = solve_offset();
    offset_.taken_out = use == OffsetUse::taken_out && offset_.cells > 0;
    if (!layers_.density.empty()) from_seen_m_ = distance_from_seen();
  }

  [[nodiscard]] TerrainFigures figures() const {
    TerrainFigures figures;
    figures.without_reference = cells_without_reference();
    figures.offset = offset_;
    figures.all = errors_where([](std::size_t) { return true; });
    if (!layers_.density.empty()) figures.by_density = by_density();
    if (!layers_.deviation_m.empty()) figures.calibration = calibration();
    if (!layers_.count.empty()) figures.paper = of_the_papers_selection();
    if (!layers_.path_distance_m.empty())
      figures.by_path_distance = by_bins(layers_.path_distance_m, kPathDistances_m);
    figures.by_slope =
        by_bins(slope_percent(layers_.reference_m, layers_.lattice), kSlopes_percent);
    for (const TerrainMask& mask : layers_.masks)
      figures.by_mask.push_back({mask.name, of_mask(mask)});
    return figures;
  }

 private:
  [[nodiscard]] bool has_reference(std::size_t cell) const {
    return std::isfinite(layers_.reference_m[cell]);
  }
  [[nodiscard]] bool has_estimate(std::size_t cell) const {
    return std::isfinite(layers_.estimated_m[cell]);
  }
  [[nodiscard]] double difference(std::size_t cell) const {
    return static_cast<double>(layers_.estimated_m[cell]) -
           static_cast<double>(layers_.reference_m[cell]);
  }
  [[nodiscard]] bool is_dense(std::size_t cell) const {
    return static_cast<double>(layers_.density[cell]) >= kDensePointsPerM2;
  }
  [[nodiscard]] bool is_seen(std::size_t cell) const { return layers_.density[cell] > 0.0F; }
  [[nodiscard]] bool is_in_gap(std::size_t cell) const {
    return static_cast<double>(from_seen_m_[cell]) <= kGap_m;
  }

  template <typename InGroup>
  [[nodiscard]] std::vector<double> differences_where(const InGroup& in_group) const {
    std::vector<double> differences;
    for (std::size_t cell = 0; cell < layers_.lattice.cells(); ++cell)
      if (has_reference(cell) && has_estimate(cell) && in_group(cell))
        differences.push_back(difference(cell));
    return differences;
  }

  template <typename InGroup>
  [[nodiscard]] TerrainErrors errors_where(const InGroup& in_group) const {
    std::uint64_t cells = 0;
    for (std::size_t cell = 0; cell < layers_.lattice.cells(); ++cell)
      if (has_reference(cell) && in_group(cell)) ++cells;
    std::vector<double> errors = differences_where(in_group);
    if (offset_.taken_out)
      for (double& error : errors) error -= offset_.median_m;
    return terrain_errors(cells, std::move(errors));
  }

  [[nodiscard]] VerticalOffset solve_offset() const {
    VerticalOffset offset;
    std::vector<double> differences;
    if (!layers_.density.empty())
      differences = differences_where([this](std::size_t cell) { return is_dense(cell); });
    offset.of_dense = !differences.empty();
    if (differences.empty()) differences = differences_where([](std::size_t) { return true; });
    offset.cells = differences.size();
    offset.median_m = median(std::move(differences));
    return offset;
  }

  [[nodiscard]] std::uint64_t cells_without_reference() const {
    std::uint64_t cells = 0;
    for (std::size_t cell = 0; cell < layers_.lattice.cells(); ++cell)
      if (has_estimate(cell) && !has_reference(cell)) ++cells;
    return cells;
  }

  [[nodiscard]] std::vector<float> distance_from_seen() const {
    std::vector<std::uint8_t> seen(layers_.lattice.cells());
    for (std::size_t cell = 0; cell < seen.size(); ++cell) seen[cell] = is_seen(cell) ? 1 : 0;
    return distance_to(seen, layers_.lattice);
  }

  /// Calls take(group) with the four tests that tell which cells belong to a group of density.
  template <typename Take>
  void for_each_density(const Take& take) const {
    take([this](std::size_t cell) { return is_dense(cell); });
    take([this](std::size_t cell) { return is_seen(cell) && !is_dense(cell); });
    take([this](std::size_t cell) { return !is_seen(cell) && is_in_gap(cell); });
    take([this](std::size_t cell) { return !is_seen(cell) && !is_in_gap(cell); });
  }

  [[nodiscard]] ErrorsByDensity by_density() const {
    std::vector<TerrainErrors> groups;
    for_each_density([&](const auto& in_group) { groups.push_back(errors_where(in_group)); });
    return {groups[0], groups[1], groups[2], groups[3]};
  }

  template <typename InGroup>
  [[nodiscard]] DeviationCalibration calibration_where(const InGroup& in_group) const {
    std::vector<JudgedHeight> heights;
    for (std::size_t cell = 0; cell < layers_.lattice.cells(); ++cell) {
      if (!has_reference(cell) || !has_estimate(cell) || !in_group(cell)) continue;
      if (!std::isfinite(layers_.deviation_m[cell])) continue;
      heights.push_back({difference(cell) - (offset_.taken_out ? offset_.median_m : 0.0),
                         static_cast<double>(layers_.deviation_m[cell])});
    }
    return calibrate(heights);
  }

  [[nodiscard]] std::vector<GroupCalibration> calibration() const {
    std::vector<GroupCalibration> groups;
    if (!layers_.density.empty()) {
      for_each_density([&](const auto& in_group) {
        groups.push_back({kDensityGroups.at(groups.size()), calibration_where(in_group)});
      });
    }
    groups.push_back({"all", calibration_where([](std::size_t) { return true; })});
    return groups;
  }

  [[nodiscard]] TerrainErrors of_the_papers_selection() const {
    const double area_m2 = layers_.lattice.cell_width_m * layers_.lattice.cell_height_m;
    return errors_where([&](std::size_t cell) {
      return static_cast<double>(layers_.count[cell]) >= kDensePointsPerM2 * area_m2;
    });
  }

  template <std::size_t N>
  [[nodiscard]] std::vector<TerrainBin> by_bins(std::span<const float> values,
                                                const std::array<double, N>& begins) const {
    std::vector<TerrainBin> bins;
    for (std::size_t i = 0; i < N; ++i) {
      const double from = begins[i];
      const double to = i + 1 < N ? begins[i + 1] : std::numeric_limits<double>::infinity();
      bins.push_back({from, to, errors_where([&](std::size_t cell) {
                        const auto value = static_cast<double>(values[cell]);
                        return value >= from && value < to;
                      })});
    }
    return bins;
  }

  [[nodiscard]] TerrainErrors of_mask(const TerrainMask& mask) const {
    return errors_where([&](std::size_t cell) {
      return mask.values[cell] != 0.0F && !std::isnan(mask.values[cell]);
    });
  }

  const TerrainLayers& layers_;
  VerticalOffset offset_{};
  std::vector<float> from_seen_m_{};  // of each cell, where density is known
};

}  // namespace

TerrainFigures compare_terrain(const TerrainLayers& layers, OffsetUse offset) {
  check_layers(layers);
  return Comparison(layers, offset).figures();
}

}  // namespace groundgrid::evaluation
