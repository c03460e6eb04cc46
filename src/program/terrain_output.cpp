#include "program/terrain_output.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "program/output_folder.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

constexpr double kGreatestLimit = 1000.0;

fs::path place_of(const io::ScanSequence& sequence, bool single_scans) {
  const fs::path folder = sequence.plain() ? fs::path{} : fs::path("sequences") / sequence.name;
  if (!single_scans) return folder / "terrain.tif";
  return sequence.plain() ? fs::path{} : folder / "terrain";
}

fs::path raster_of(const fs::path& folder, const io::ScanFile& scan) {
  return folder / (scan.name + ".tif");
}

/// terrain.tif has its layers in terrain_layers.tif.
fs::path layers_beside(const fs::path& raster) {
  return raster.parent_path() / (raster.stem().string() + "_layers.tif");
}

void write_layers(const fs::path& path, const TerrainView& terrain, const TerrainLayers& layers,
                  const TraversabilityLimits& limits, const std::string& crs) {
  geotiff::LayersMosaic scan(path, limits, crs);
  scan.add(terrain, layers);
  if (!scan.empty()) scan.finish();
}

}  // namespace

void TerrainOptions::add_to(CLI::App& command) {
  CLI::Option* const terrain = command.add_flag(
      "--terrain", wanted_, "Write the terrain of each drive (or single scan) as a GeoTIFF");
  command
      .add_flag("--terrain-as-seen", as_seen_,
                "Leave gaps in the terrain, and what stands out of it, as the scans showed them")
      ->needs(terrain);
  command
      .add_option("--crs", crs_,
                  "Coordinate reference system of the terrain, e.g. EPSG:32632 [a local frame]")
      ->needs(terrain);
  CLI::Option* const origin =
      command
          .add_option("--origin", origin_m_,
                      "East, north and height of the origin of the poses in that system, metres")
          ->expected(3)
          ->delimiter(',')
          ->type_name("E,N,H")
          ->needs(terrain);
  command
      .add_option("--heading-deg", heading_deg_,
                  "Direction of the poses' x axis, degrees from east towards north [0]; the cells "
                  "turn with it, so some labels change")
      ->needs(origin);
  CLI::Option* const layers =
      command
          .add_flag("--terrain-layers", layers_,
                    "Write slope, step, roughness, obstacles and traversability as a second "
                    "GeoTIFF beside the terrain")
          ->needs(terrain);
  const auto add_limit = [&](const char* name, double& value, const char* text) {
    command.add_option(name, value, text)
        ->capture_default_str()
        ->check(CLI::Range(0.0, kGreatestLimit))
        ->needs(layers);
  };
  add_limit("--drive-slope-deg", limits_.max_slope_deg, "Steepest slope that can be driven");
  add_limit("--drive-step-m", limits_.max_step_m, "Highest step that can be driven");
  add_limit("--drive-roughness-m", limits_.max_roughness_m, "Greatest roughness, too");
  add_limit("--drive-over-m", limits_.min_obstacle_height_m,
            "Lower returns above the ground are no obstacle");
  add_limit("--drive-under-m", limits_.overhang_clearance_m,
            "Higher returns above the ground are no obstacle");
}

void TerrainOptions::check() const {
  const bool finite = std::all_of(origin_m_.begin(), origin_m_.end(),
                                  [](double number) { return std::isfinite(number); });
  if (!finite || !std::isfinite(heading_deg_))
    throw UsageError("--origin and --heading-deg: expected finite numbers");
  try {
    geotiff::check_crs(crs_);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--crs: {}", error.what()));
  }
}

Eigen::Isometry3d TerrainOptions::T_map_level() const {
  Eigen::Isometry3d T_map_level = Eigen::Isometry3d::Identity();
  if (origin_m_.empty()) return T_map_level;
  T_map_level.translation() = Eigen::Vector3d(origin_m_[0], origin_m_[1], origin_m_[2]);
  T_map_level.linear() =
      Eigen::AngleAxisd(heading_deg_ * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  return T_map_level;
}

std::optional<geotiff::SurfaceOptions> TerrainOptions::surface() const {
  if (as_seen_) return std::nullopt;
  return geotiff::SurfaceOptions{};
}

TerrainOutput::TerrainOutput(fs::path output, const io::ScanSequence& sequence, bool single_scans,
                             const TerrainOptions& options)
    : output_(std::move(output)),
      place_(place_of(sequence, single_scans)),
      crs_(options.crs()),
      surface_(options.surface()),
      limits_(options.limits()) {
  if (single_scans) {
    make_folder(output_ / place_);
    return;
  }
  mosaic_.emplace(output_ / place_, crs_, surface_);
  if (options.layers_wanted()) layers_.emplace(layers_beside(output_ / place_), limits_, crs_);
}

void TerrainOutput::check(const fs::path& output, const io::ScanSequence& sequence,
                          bool single_scans, const InputFiles& inputs) {
  const fs::path place = output / place_of(sequence, single_scans);
  const auto keep = [&inputs](const fs::path& raster) {
    inputs.keep(raster);
    inputs.keep(layers_beside(raster));
  };
  if (!single_scans) return keep(place);
  for (const io::ScanFile& scan : sequence.scans) keep(raster_of(place, scan));
}

void TerrainOutput::add(const io::ScanFile& scan, const TerrainView& terrain,
                        const TerrainLayers* layers) {
  if (mosaic_) {
    mosaic_->add(terrain);
    if (layers_ && layers != nullptr) layers_->add(terrain, *layers);
    return;
  }
  const fs::path raster = raster_of(output_ / place_, scan);
  geotiff::write_terrain(raster, terrain, crs_, surface_);
  if (layers != nullptr) write_layers(layers_beside(raster), terrain, *layers, limits_, crs_);
}

bool TerrainOutput::finish() {
  if (!mosaic_) return true;
  if (mosaic_->empty()) {
    spdlog::warn("{}: not written, since no scan showed any ground", (output_ / place_).string());
    return false;
  }
  mosaic_->finish();
  if (layers_ && !layers_->empty()) layers_->finish();
  return true;
}

}  // namespace groundgrid::program
