#include "geotiff/terrain_mosaic.hpp"

#include <optional>
#include <utility>

#include "geotiff/crs.hpp"
#include "geotiff/drive_terrain.hpp"
#include "geotiff/terrain_file.hpp"

namespace groundgrid::geotiff {

class TerrainMosaic::Tiles {
 public:
  Tiles(std::filesystem::path path, const std::string& crs,
        const std::optional<SurfaceOptions>& surface)
      : path_(std::move(path)), crs_(read_crs(crs)), terrain_(path_, surface) {}

  void finish() const;
  DriveTerrain& terrain() { return terrain_; }

 private:
  std::filesystem::path path_;
  std::optional<OGRSpatialReference> crs_;
  DriveTerrain terrain_;
};

void TerrainMosaic::Tiles::finish() const {
  if (terrain_.empty()) fail_without_terrain(path_);
  TerrainFile file(path_, terrain_.grid(), crs_);
  DriveTerrain::Blocks blocks(terrain_);
  for (int row = 0; row < file.block_rows(); ++row) {
    for (int column = 0; column < file.block_columns(); ++column) {
      TerrainBlock* const block = blocks.read(file.cells_of(column, row));
      if (block != nullptr) file.write(column, row, *block);
    }
  }
  file.commit();
}

TerrainMosaic::TerrainMosaic(std::filesystem::path path, const std::string& crs,
                             const std::optional<SurfaceOptions>& surface)
    : tiles_(std::make_unique<Tiles>(std::move(path), crs, surface)) {}
TerrainMosaic::~TerrainMosaic() = default;
TerrainMosaic::TerrainMosaic(TerrainMosaic&&) noexcept = default;
TerrainMosaic& TerrainMosaic::operator=(TerrainMosaic&&) noexcept = default;

void TerrainMosaic::add(const TerrainView& terrain) { tiles_->terrain().add(terrain); }
void TerrainMosaic::finish() { tiles_->finish(); }
bool TerrainMosaic::empty() const { return tiles_->terrain().empty(); }
std::size_t TerrainMosaic::resident_bytes() const { return tiles_->terrain().resident_bytes(); }

}  // namespace groundgrid::geotiff
