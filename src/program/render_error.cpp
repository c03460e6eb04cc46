#include "program/render_error.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/terrain_metrics.hpp"
#include "geotiff/height_raster.hpp"
#include "program/length_units.hpp"
#include "program/picture_options.hpp"
#include "program/render_map.hpp"
#include "rendering/map_picture.hpp"
#include "rendering/nice_numbers.hpp"
#include "rendering/png_file.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using evaluation::OffsetUse;

// More cells than this a side show in no picture.
constexpr int kMostCells = 4000;

struct RenderErrorOptions {
  fs::path map;
  fs::path reference;
  std::string unit;
  bool solve_offset = false;
  PictureOptions picture;
  PathOptions path;
  double limit_m = 0.0;
};

std::vector<float> resample(const RenderErrorOptions& options, const geotiff::RasterFrame& frame) {
  geotiff::ResampledHeights reference =
      geotiff::resample_heights(options.reference, frame,
                                options.unit.empty() ? std::optional<geotiff::LengthUnit>{}
                                                     : length_units().at(options.unit));
  for (const std::string& remark : reference.remarks) spdlog::warn("{}", remark);
  return std::move(reference.heights_m);
}

std::vector<float> errors_of(const std::vector<float>& estimate,
                             const std::vector<float>& reference, double offset_m) {
  std::vector<float> errors(estimate.size());
  std::transform(estimate.begin(), estimate.end(), reference.begin(), errors.begin(),
                 [offset_m](float estimated, float true_height) {
                   return static_cast<float>(static_cast<double>(estimated) -
                                             static_cast<double>(true_height) - offset_m);
                 });
  return errors;
}

// A round number that nearly all errors are below.
double limit_of(const std::vector<float>& errors) {
  constexpr double kShareBeyond = 0.05;
  constexpr double kLeast_m = 0.05;
  std::vector<float> sizes(errors.size());
  std::transform(errors.begin(), errors.end(), sizes.begin(),
                 [](float error) { return std::abs(error); });
  return rendering::nice_above(
      std::max(kLeast_m, rendering::range_of(std::move(sizes), kShareBeyond).high));
}

std::string caption_of(const evaluation::TerrainFigures& figures) {
  const evaluation::TerrainErrors& all = figures.all;
  const std::string offset =
      figures.offset.taken_out
          ? fmt::format("; {:+.3f} m of offset taken out", figures.offset.median_m)
          : "";
  return fmt::format("RMSE {:.3f} m, bias {:+.3f} m, coverage {:.1f} % of {} cells{}", all.rmse_m,
                     all.bias_m, 100.0 * all.coverage(), all.cells, offset);
}

void render_error(const RenderErrorOptions& options) {
  options.picture.check();
  InputFiles inputs;
  for (const fs::path& file : {options.map, options.reference}) inputs.add(file);
  options.path.add_files(inputs);
  inputs.keep(options.picture.output());
  const geotiff::HeightRaster map = geotiff::read_height_raster(options.map);
  std::vector<float> reference = resample(options, map.frame);
  const evaluation::TerrainFigures figures = evaluation::compare_terrain(
      {.lattice = {map.frame.columns, map.frame.rows, std::abs(map.frame.transform[1]),
                   std::abs(map.frame.transform[5])},
       .estimated_m = map.heights_m,
       .reference_m = reference,
       .density = map.density},
      options.solve_offset ? OffsetUse::taken_out : OffsetUse::reported);
  const double offset_m = figures.offset.taken_out ? figures.offset.median_m : 0.0;
  std::vector<float> errors = errors_of(map.heights_m, reference, offset_m);
  const double limit_m = options.limit_m > 0.0 ? options.limit_m : limit_of(errors);
  rendering::ErrorPicture picture{
      .errors = rendering::coarsened(grid_of(map.frame, std::move(errors)), kMostCells),
      .reference = rendering::coarsened(grid_of(map.frame, std::move(reference)), kMostCells),
      .limit_m = limit_m,
      .title = options.picture.title_or(fmt::format(
          "{} against {}", options.map.filename().string(), options.reference.filename().string())),
      .caption = caption_of(figures)};
  picture.path = options.path.read(picture.errors);
  const auto size = options.picture.size_or(
      rendering::map_size(picture.errors.width_m(), picture.errors.height_m()));
  rendering::write_png(options.picture.output(), rendering::draw_errors(picture, size));
}

}  // namespace

void add_render_error(CLI::App& render) {
  CLI::App* const command =
      render.add_subcommand("error", "What a terrain is off by, against a reference of heights");
  const auto options = std::make_shared<RenderErrorOptions>();
  command->add_option("MAP", options->map, "GeoTIFF of heights in metres, as segment --terrain")
      ->required();
  command->add_option("REFERENCE", options->reference, "GeoTIFF of the true heights")->required();
  options->picture.add_to(*command, ".png", "by the terrain's shape");
  options->path.add_to(*command);
  command
      ->add_option("--limit", options->limit_m,
                   "Error in metres that the ends of the colours stand for [a round number that 95 "
                   "% of the errors are below]")
      ->check(CLI::Range(0.001, 1000.0));
  command->add_flag("--solve-offset", options->solve_offset,
                    "Take the median difference in dense cells out of all errors");
  add_reference_unit(*command, options->unit);
  command->callback([options] { render_error(*options); });
}

}  // namespace groundgrid::program
