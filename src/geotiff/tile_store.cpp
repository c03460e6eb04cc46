#include "geotiff/tile_store.hpp"

#include <unistd.h>

#include <cerrno>
#include <type_traits>

#include "io/error.hpp"
#include "io/hidden_file.hpp"

namespace groundgrid::geotiff {
namespace {

static_assert(std::is_trivially_copyable_v<MosaicTile>);
static_assert(sizeof(MosaicTile) == MosaicTile::kCells * 28);
static_assert(std::is_trivially_copyable_v<LayersTile>);
static_assert(LayersTile::kSide == MosaicTile::kSide);

/// The quotient, rounded down for negative numbers too.
std::int64_t tile_of(std::int64_t cell) {
  const std::int64_t tile = cell / MosaicTile::kSide;
  return cell % MosaicTile::kSide < 0 ? tile - 1 : tile;
}

}  // namespace

CellRange cells_of(TileIndex index) {
  const std::int64_t column = index.first * MosaicTile::kSide;
  const std::int64_t row = index.second * MosaicTile::kSide;
  return {column, column + MosaicTile::kSide, row, row + MosaicTile::kSide};
}

CellRange tiles_of(const CellRange& cells) {
  return {tile_of(cells.first_column), tile_of(cells.end_column - 1) + 1, tile_of(cells.first_row),
          tile_of(cells.end_row - 1) + 1};
}

template <typename Tile>
BasicTileStore<Tile>::BasicTileStore(std::filesystem::path result)
    : result_(std::move(result)), file_(io::file_without_name(result_)) {}

template <typename Tile>
Tile& BasicTileStore<Tile>::load(Index index) {
  const auto found = resident_.find(index);
  if (found != resident_.end()) return *found->second;
  auto tile = std::make_unique<Tile>();
  const auto place = places_.find(index);
  if (place != places_.end()) read(place->second, *tile);
  return *resident_.emplace(index, std::move(tile)).first->second;
}

template <typename Tile>
void BasicTileStore<Tile>::keep_only(const CellRange& kept) {
  for (auto tile = resident_.begin(); tile != resident_.end();) {
    if (!overlap(cells_of(tile->first), kept).empty()) {
      ++tile;
      continue;
    }
    write(tile->first, *tile->second);
    tile = resident_.erase(tile);
  }
}

template <typename Tile>
const Tile* BasicTileStore<Tile>::look_up(Index index, Tile& buffer) const {
  const auto found = resident_.find(index);
  if (found != resident_.end()) return found->second.get();
  const auto place = places_.find(index);
  if (place == places_.end()) return nullptr;
  read(place->second, buffer);
  return &buffer;
}

template <typename Tile>
void BasicTileStore<Tile>::write(Index index, const Tile& tile) {
  const auto end = static_cast<off_t>(places_.size() * sizeof(Tile));
  const auto known = places_.find(index);
  const off_t place = known == places_.end() ? end : known->second;
  const char* const bytes = reinterpret_cast<const char*>(&tile);
  for (std::size_t done = 0; done < sizeof(Tile);) {
    const ssize_t written =
        ::pwrite(file_.get(), bytes + done, sizeof(Tile) - done, place + static_cast<off_t>(done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) io::fail_to_write(result_, io::system_message(errno));
    done += static_cast<std::size_t>(written);
  }
  places_.emplace(index, place);
}

template <typename Tile>
void BasicTileStore<Tile>::read(off_t place, Tile& tile) const {
  char* const bytes = reinterpret_cast<char*>(&tile);
  for (std::size_t done = 0; done < sizeof(Tile);) {
    const ssize_t got =
        ::pread(file_.get(), bytes + done, sizeof(Tile) - done, place + static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0)
      throw io::Error({.file = result_,
                       .expected = "the tiles of the drive that were set aside beside it",
                       .got = got < 0 ? io::system_message(errno) : "an end of file"});
    done += static_cast<std::size_t>(got);
  }
}

template class BasicTileStore<MosaicTile>;
template class BasicTileStore<LayersTile>;

}  // namespace groundgrid::geotiff
