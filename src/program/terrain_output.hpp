#pragma once

#include <CLI/App.hpp>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geotiff/layers_mosaic.hpp"
#include "geotiff/terrain_mosaic.hpp"
#include "groundgrid/terrain_layers.hpp"
#include "groundgrid/terrain_view.hpp"
#include "io/scan_sequence.hpp"
#include "program/input_files.hpp"

namespace groundgrid::program {

/// The flags that say whether and in what frame the terrain is written.
class TerrainOptions {
 public:
  void add_to(CLI::App& command);

  /// Throws UsageError where a number is not finite or the CRS cannot be that of a terrain.
  void check() const;

  /// How gaps are closed; empty where cells stay as scans showed them.
  [[nodiscard]] std::optional<geotiff::SurfaceOptions> surface() const;
  [[nodiscard]] bool wanted() const { return wanted_; }
  /// Empty for a local frame.
  [[nodiscard]] const std::string& crs() const { return crs_; }
  /// Whether the layers for planners are wanted beside it, and up to where a vehicle drives.
  [[nodiscard]] bool layers_wanted() const { return layers_; }
  [[nodiscard]] const TraversabilityLimits& limits() const { return limits_; }
  /// Where the frame of the poses, once it is level, lies in that of the terrain.
  [[nodiscard]] Eigen::Isometry3d T_map_level() const;

 private:
  bool wanted_ = false;
  bool as_seen_ = false;
  std::string crs_;
  std::vector<double> origin_m_;
  double heading_deg_ = 0.0;
  bool layers_ = false;
  TraversabilityLimits limits_;
};

/// Where the terrain of one sequence goes: a mosaic of the drive or, where the map is forgotten
/// between scans, one raster a scan.
class TerrainOutput {
 public:
  /// `output` is the folder of the whole run, whose parts are there already. Throws io::Error,
  /// std::invalid_argument (unknown CRS).
  TerrainOutput(std::filesystem::path output, const io::ScanSequence& sequence, bool single_scans,
                const TerrainOptions& options);

  /// Throws UsageError where a raster would replace one of the inputs.
  static void check(const std::filesystem::path& output, const io::ScanSequence& sequence,
                    bool single_scans, const InputFiles& inputs);

  /// Takes the map as it stands after the scan, and its layers where they are wanted. Throws
  /// io::Error.
  void add(const io::ScanFile& scan, const TerrainView& terrain, const TerrainLayers* layers);

  /// Writes the mosaics. False, with a warning, where no scan showed any ground. Throws io::Error.
  bool finish();

  /// Files or, for single scans, the folder with one file a scan; relative to the run's folder.
  [[nodiscard]] const std::filesystem::path& place() const { return place_; }

 private:
  std::filesystem::path output_;
  std::filesystem::path place_;
  std::string crs_;
  std::optional<geotiff::SurfaceOptions> surface_;
  TraversabilityLimits limits_;
  std::optional<geotiff::TerrainMosaic> mosaic_;
  std::optional<geotiff::LayersMosaic> layers_;
};

}  // namespace groundgrid::program
