#include "geotiff/drive_terrain.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "array_output.hpp"
#include "bindings.hpp"
#include "file_path.hpp"
#include "shared_grid.hpp"

namespace groundgrid::python {
namespace {

using geotiff::RasterGrid;
using geotiff::TerrainBlock;

/// The terrain of a drive, whose callers take turns.
class SharedTerrain {
 public:
  SharedTerrain(const std::filesystem::path& result, bool as_seen)
      : terrain_(result,
                 as_seen ? std::optional<geotiff::SurfaceOptions>{} : geotiff::SurfaceOptions{}) {}

  void add(SharedGrid& grid) {
    grid.visit([&](const GroundGrid& map) {
      const std::lock_guard turn(mutex_);
      terrain_.add(map.terrain());
      return true;
    });
  }

  bool empty() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return terrain_.empty();
  }

  RasterGrid raster() {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    return terrain_.empty() ? RasterGrid{} : terrain_.grid();
  }

  /// All bands of one block; empty where nothing is known of it.
  std::vector<float> block(std::int64_t column, std::int64_t row) {
    const nb::gil_scoped_release no_gil;
    const std::lock_guard turn(mutex_);
    geotiff::DriveTerrain::Blocks blocks(terrain_);
    TerrainBlock* const block = blocks.read(geotiff::cells_of_block(terrain_.grid(), column, row));
    if (block == nullptr) return {};
    constexpr std::size_t pixels = std::size_t{TerrainBlock::kSide} * TerrainBlock::kSide;
    return {block->band(0), block->band(0) + geotiff::kTerrainBands * pixels};
  }

 private:
  std::mutex mutex_;
  geotiff::DriveTerrain terrain_;
};

nb::object block_of(SharedTerrain& self, std::int64_t column, std::int64_t row) {
  const RasterGrid grid = self.raster();
  if (column < 0 || row < 0 || column >= geotiff::blocks_over(grid.columns) ||
      row >= geotiff::blocks_over(grid.rows))
    throw nb::index_error("block: outside of the raster");
  constexpr auto side = static_cast<std::size_t>(TerrainBlock::kSide);
  std::vector<float> pixels = self.block(column, row);
  if (pixels.empty()) return nb::none();
  return to_array(std::move(pixels), {geotiff::kTerrainBands, side, side});
}

nb::tuple shape_of(SharedTerrain& self) {
  const RasterGrid grid = self.raster();
  return nb::make_tuple(grid.rows, grid.columns);
}

nb::tuple corner_of(SharedTerrain& self) {
  const RasterGrid grid = self.raster();
  return nb::make_tuple(grid.min_x_m,
                        grid.min_y_m + static_cast<double>(grid.rows) * grid.resolution_m);
}

}  // namespace

void bind_drive_terrain(nb::module_& module) {
  nb::class_<SharedTerrain> terrain(module, "DriveTerrain",
                                    "The terrain of a whole drive, made scan by scan, as the "
                                    "blocks of a raster with row 0 in the north.");
  terrain.def(
      "__init__",
      [](SharedTerrain* self, nb::handle result, bool as_seen) {
        new (self) SharedTerrain(path_from(result), as_seen);
      },
      nb::arg("result"), nb::arg("as_seen") = false,
      nb::sig("def __init__(self, result: str | os.PathLike[str], as_seen: bool = False) -> None"),
      "result is the file to be, whose folder holds what does not fit in memory. With as_seen\n"
      "gaps are not filled, and what stands out of the ground is not taken away.");
  terrain.def("add", &SharedTerrain::add, nb::arg("grid"),
              "Adds the map as it stands after the grid's last scan.");
  terrain.def_prop_ro("empty", &SharedTerrain::empty, "Whether no scan showed any ground.");
  terrain.def_prop_ro("shape", &shape_of, nb::sig("def shape(self) -> tuple[int, int]"),
                      "Rows and columns of the raster.");
  terrain.def_prop_ro("corner_m", &corner_of, nb::sig("def corner_m(self) -> tuple[float, float]"),
                      "Map frame x and y of the raster's north-western corner, metres.");
  terrain.def_prop_ro(
      "resolution_m", [](SharedTerrain& self) { return self.raster().resolution_m; },
      "Length of a cell's side, metres; 0 where there is no terrain.");
  terrain.def("block", &block_of, nb::arg("column"), nb::arg("row"),
              nb::sig("def block(self, column: int, row: int) -> "
                      "numpy.typing.NDArray[numpy.float32] | None"),
              "Bands × 256 × 256 pixels of a block, -9999 where nothing is known; None where that\n"
              "is so everywhere. Blocks of the last row and column reach beyond the raster.");
}

}  // namespace groundgrid::python
