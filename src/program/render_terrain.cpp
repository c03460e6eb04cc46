#include "program/render_terrain.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geotiff/height_raster.hpp"
#include "geotiff/hillshade.hpp"
#include "io/error.hpp"
#include "program/picture_options.hpp"
#include "program/render_map.hpp"
#include "program/usage_error.hpp"
#include "program/view_options.hpp"
#include "rendering/map_picture.hpp"
#include "rendering/png_file.hpp"
#include "rendering/terrain_view.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using rendering::HeightGrid;
using rendering::ValueRange;

// More cells than this a side show in no picture.
constexpr int kMostCellsFromAbove = 4000;
constexpr int kMostCellsInPerspective = 1500;

// Few cells beyond these heights must not take the colours from all others.
constexpr double kShareBeyondColors = 0.005;

struct RenderTerrainOptions {
  fs::path terrain;
  PictureOptions picture;
  ViewOptions view;
  PathOptions path;
  std::vector<double> heights_m;
  double exaggeration = 0.0;  ///< 0: as the view needs.
};

HeightGrid read_grid(const fs::path& file, int most_cells) {
  geotiff::HeightRaster raster = geotiff::read_height_raster(file);
  HeightGrid grid = rendering::cropped(grid_of(raster.frame, std::move(raster.heights_m)));
  if (grid.columns == 0)
    throw io::Error({.file = file, .expected = "heights", .got = "a raster without any"});
  return rendering::coarsened(grid, most_cells);
}

ValueRange color_range(const RenderTerrainOptions& options, const HeightGrid& grid) {
  constexpr double kLeastSpan_m = 0.1;
  if (options.heights_m.empty()) {
    const ValueRange range = rendering::range_of(grid.heights_m, kShareBeyondColors);
    return {range.low, std::max(range.high, range.low + kLeastSpan_m)};
  }
  if (options.heights_m[0] < options.heights_m[1])
    return {options.heights_m[0], options.heights_m[1]};
  throw UsageError("--heights: expected the lower height first");
}

rendering::TerrainPicture read_picture(const RenderTerrainOptions& options) {
  rendering::TerrainPicture picture;
  picture.grid = read_grid(
      options.terrain, options.view.perspective() ? kMostCellsInPerspective : kMostCellsFromAbove);
  picture.heights_m = color_range(options, picture.grid);
  picture.path = options.path.read(picture.grid);
  picture.title = options.picture.title_or(options.terrain.filename().string());
  picture.caption = extent_words(picture.grid);
  return picture;
}

void shade(rendering::TerrainPicture& picture, double exaggeration) {
  const HeightGrid& grid = picture.grid;
  picture.shade = geotiff::hillshade(
      {grid.columns, grid.rows, grid.cell_width_m, grid.cell_height_m, grid.heights_m},
      exaggeration);
  picture.level_shade = geotiff::kLevelShade;
}

rendering::Image draw_from_above(const RenderTerrainOptions& options,
                                 rendering::TerrainPicture picture) {
  constexpr double kUsual = 2.0;
  shade(picture, options.exaggeration > 0.0 ? options.exaggeration : kUsual);
  return rendering::draw_terrain_from_above(
      picture, options.picture.size_or(
                   rendering::map_size(picture.grid.width_m(), picture.grid.height_m())));
}

rendering::Image draw_in_perspective(const RenderTerrainOptions& options,
                                     rendering::TerrainPicture picture) {
  const double exaggeration =
      options.exaggeration > 0.0 ? options.exaggeration : rendering::fitting_exaggeration(picture);
  shade(picture, exaggeration);
  if (exaggeration != 1.0) picture.caption += fmt::format("; heights \u00d7 {:g}", exaggeration);
  return rendering::draw_terrain_in_perspective(rendering::PerspectiveRenderer(), picture,
                                                options.view.point(), exaggeration,
                                                options.picture.size_or({1400, 900}));
}

void render_terrain(const RenderTerrainOptions& options) {
  options.picture.check();
  options.view.check();
  InputFiles inputs;
  inputs.add(options.terrain);
  options.path.add_files(inputs);
  inputs.keep(options.picture.output());
  rendering::TerrainPicture picture = read_picture(options);
  rendering::write_png(options.picture.output(),
                       options.view.perspective() ? draw_in_perspective(options, std::move(picture))
                                                  : draw_from_above(options, std::move(picture)));
}

}  // namespace

void add_render_terrain(CLI::App& render) {
  CLI::App* const command =
      render.add_subcommand("terrain", "A terrain, hillshaded, in the colours of its heights");
  const auto options = std::make_shared<RenderTerrainOptions>();
  command->add_option("TERRAIN", options->terrain, "GeoTIFF of heights, as segment --terrain")
      ->required();
  options->picture.add_to(*command, ".png", "by the terrain's shape");
  options->view.add_to(*command, -25.0, 35.0);
  options->path.add_to(*command);
  command
      ->add_option("--heights", options->heights_m,
                   "Heights in metres that the ends of the colours stand for [those of the terrain "
                   "but for half a percent of the cells at both ends]")
      ->expected(2)
      ->delimiter(',')
      ->type_name("LOW,HIGH");
  command
      ->add_option("--exaggeration", options->exaggeration,
                   "How many times steeper slopes are lit, and in perspective drawn, than they are "
                   "[2; in perspective as it fits]")
      ->check(CLI::Range(0.1, 100.0));
  command->callback([options] { render_terrain(*options); });
}

}  // namespace groundgrid::program
