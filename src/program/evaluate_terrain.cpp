#include "program/evaluate_terrain.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/terrain_metrics.hpp"
#include "evaluation/terrain_report.hpp"
#include "geotiff/height_raster.hpp"
#include "io/error.hpp"
#include "program/json_text.hpp"
#include "program/length_units.hpp"
#include "program/standard_output.hpp"
#include "program/terrain_path.hpp"
#include "program/usage_error.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using geotiff::HeightRaster;
using geotiff::LengthUnit;

struct TerrainEvaluationOptions {
  fs::path map;
  fs::path reference;
  std::string reference_unit;
  fs::path groups;
  fs::path path;
  fs::path calibration;
  std::vector<std::string> masks;
  bool solve_offset = false;
  bool json = false;
};

struct NamedLayer {
  std::string name;
  std::vector<float> values;
};

std::pair<std::string, fs::path> name_and_file(const std::string& mask) {
  const std::size_t sign = mask.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == mask.size())
    throw UsageError(fmt::format("--mask: expected NAME=FILE.tif, got '{}'", mask));
  return {mask.substr(0, sign), mask.substr(sign + 1)};
}

evaluation::CellLattice lattice_of(const geotiff::RasterFrame& frame) {
  return {frame.columns, frame.rows, std::abs(frame.transform[1]), std::abs(frame.transform[5])};
}

/// What is compared, cell by cell.
class TerrainEvaluation {
 public:
  explicit TerrainEvaluation(const TerrainEvaluationOptions& options) : options_(options) {
    std::vector<std::pair<std::string, fs::path>> masks;
    for (const std::string& mask : options.masks) masks.push_back(name_and_file(mask));
    read_terrain();
    reference_m_ = resample(options.reference, unit());
    for (const auto& [name, file] : masks)
      masks_.push_back({name, geotiff::resample_mask(file, terrain_.frame)});
    if (!options.path.empty())
      path_distance_m_ = distance_from_path(
          options.path,
          options.calibration.empty() ? std::optional<fs::path>{} : options.calibration,
          terrain_.frame, lattice_of(terrain_.frame));
  }

  [[nodiscard]] evaluation::TerrainReport report() {
    const evaluation::OffsetUse use =
        options_.solve_offset ? evaluation::OffsetUse::taken_out : evaluation::OffsetUse::reported;
    if (terrain_.density.empty())
      remarks_.emplace_back(
          "no band says how densely the cells were seen, so there are no groups; "
          "--groups takes them from a terrain that groundgrid wrote");
    return {.map = options_.map.string(),
            .reference = options_.reference.string(),
            .lattice = lattice_of(terrain_.frame),
            .figures = evaluation::compare_terrain(layers(), use),
            .remarks = remarks_};
  }

 private:
  // The cells are the map's own or, where the groups come from another one, those of that one.
  void read_terrain() {
    if (options_.groups.empty()) {
      terrain_ = geotiff::read_height_raster(options_.map);
      return;
    }
    terrain_ = geotiff::read_height_raster(options_.groups);
    if (terrain_.density.empty())
      throw io::Error(
          {.file = options_.groups,
           .expected = "a terrain with a band 'density', as segment --terrain writes it",
           .got = "none of that name"});
    terrain_.heights_m = resample(options_.map, {});
    terrain_.deviation_m.clear();  // of the terrain that gives the groups, not of this one
  }

  [[nodiscard]] std::optional<LengthUnit> unit() const {
    if (options_.reference_unit.empty()) return std::nullopt;
    return length_units().at(options_.reference_unit);
  }

  std::vector<float> resample(const fs::path& file, std::optional<LengthUnit> unit) {
    geotiff::ResampledHeights result = geotiff::resample_heights(file, terrain_.frame, unit);
    for (std::string& remark : result.remarks) remarks_.push_back(std::move(remark));
    return std::move(result.heights_m);
  }

  [[nodiscard]] evaluation::TerrainLayers layers() const {
    evaluation::TerrainLayers layers{.lattice = lattice_of(terrain_.frame),
                                     .estimated_m = terrain_.heights_m,
                                     .reference_m = reference_m_,
                                     .density = terrain_.density,
                                     .deviation_m = terrain_.deviation_m,
                                     .count = terrain_.count,
                                     .path_distance_m = path_distance_m_};
    for (const NamedLayer& mask : masks_) layers.masks.push_back({mask.name, mask.values});
    return layers;
  }

  const TerrainEvaluationOptions& options_;
  HeightRaster terrain_{};
  std::vector<float> reference_m_{};
  std::vector<float> path_distance_m_{};
  std::vector<NamedLayer> masks_{};
  std::vector<std::string> remarks_{};
};

void evaluate_terrain(const TerrainEvaluationOptions& options, const Arguments& arguments) {
  const evaluation::TerrainReport report = TerrainEvaluation(options).report();
  if (!options.json) return print_result(evaluation::to_table(report));
  nlohmann::ordered_json json = json_heading("evaluate-terrain");
  json["arguments"] = arguments;
  json.update(evaluation::to_json(report));
  print_result(to_text(json));
}

}  // namespace

void add_evaluate_terrain(CLI::App& app, const Arguments& arguments) {
  CLI::App* const command = app.add_subcommand(
      "evaluate-terrain", "Score a terrain, ours or another, against a reference of heights");
  const auto options = std::make_shared<TerrainEvaluationOptions>();
  command->add_option("MAP", options->map, "GeoTIFF of heights in metres, as segment --terrain")
      ->required();
  command->add_option("REFERENCE", options->reference, "GeoTIFF of the true heights")->required();
  command->add_flag("--solve-offset", options->solve_offset,
                    "Take the median difference in dense cells out of all figures");
  add_reference_unit(*command, options->reference_unit);
  command->add_option("--groups", options->groups,
                      "Take cells and their density from this terrain of segment --terrain [MAP]");
  CLI::Option* const path = command->add_option(
      "--path", options->path,
      "Poses of the drive in the terrain's frame, KITTI or TUM: figures by distance from them");
  command
      ->add_option("--calibration", options->calibration,
                   "calib.txt whose Tr makes LiDAR poses of the camera poses in --path")
      ->needs(path);
  command
      ->add_option("--mask", options->masks,
                   "Figures of the cells that are not 0 in this GeoTIFF; may be repeated")
      ->type_name("NAME=FILE")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, arguments] { evaluate_terrain(*options, arguments); });
}

}  // namespace groundgrid::program
