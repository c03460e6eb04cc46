#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "geotiff/cell_range.hpp"
#include "geotiff/layers_tile.hpp"
#include "geotiff/mosaic_tile.hpp"
#include "io/file_descriptor.hpp"

namespace groundgrid::geotiff {

/// Tile (i, j) holds the columns from i · kSide on and the rows from j · kSide on.
using TileIndex = std::pair<std::int64_t, std::int64_t>;

/// The tiles of a lattice without borders, some in memory and the others in one file. That file
/// has no name, so that it is gone with the process however that ends.
template <typename Tile>
class BasicTileStore {
 public:
  using Index = TileIndex;

  /// `result` is the file to be: its folder holds the tiles too. Throws io::Error where it is not
  /// writable.
  explicit BasicTileStore(std::filesystem::path result);
  ~BasicTileStore() = default;
  BasicTileStore(const BasicTileStore&) = delete;
  BasicTileStore& operator=(const BasicTileStore&) = delete;
  BasicTileStore(BasicTileStore&&) = delete;
  BasicTileStore& operator=(BasicTileStore&&) = delete;

  /// The tile, to be changed: from memory, from the file or, where it is new, without anything
  /// known. Throws io::Error where it cannot be read.
  Tile& load(Index index);

  /// Sends the tiles that hold no cell of `kept` to the file. Throws io::Error where they cannot
  /// be written; they then stay in memory.
  void keep_only(const CellRange& kept);

  /// The tile, from memory or read into `buffer`; null where there is none. Throws io::Error where
  /// it cannot be read.
  const Tile* look_up(Index index, Tile& buffer) const;

  [[nodiscard]] std::size_t resident_bytes() const { return resident_.size() * sizeof(Tile); }

 private:
  void write(Index index, const Tile& tile);
  void read(off_t place, Tile& tile) const;

  std::filesystem::path result_;
  io::FileDescriptor file_;
  std::map<Index, std::unique_ptr<Tile>> resident_;
  std::map<Index, off_t> places_;  ///< In the file; a tile keeps its place when it comes back.
};

using TileStore = BasicTileStore<MosaicTile>;
using LayersTileStore = BasicTileStore<LayersTile>;

/// The cells of a tile.
CellRange cells_of(TileIndex index);

/// The tiles that hold a cell of the range, as a range of tiles.
CellRange tiles_of(const CellRange& cells);

}  // namespace groundgrid::geotiff
