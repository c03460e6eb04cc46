#pragma once

#include <cstddef>

#include "groundgrid/export.hpp"

namespace groundgrid {

/// Does the tile of its number when called. It refers to a callable object, `void(std::size_t)`,
/// that is not its own: copies are cheap, allocate nothing and are all the same work.
class TileTask {
 public:
  template <typename Function>
  explicit TileTask(const Function& function)
      : function_(&function), call_([](const void* callable, std::size_t tile) {
          (*static_cast<const Function*>(callable))(tile);
        }) {}

  void operator()(std::size_t tile) const { call_(function_, tile); }

 private:
  const void* function_;
  void (*call_)(const void*, std::size_t);
};

/// Where a GroundGrid object takes its threads from: derive from it to run on threads of your own.
/// groundgrid/tbb_executor.hpp has one for oneTBB.
class GROUNDGRID_EXPORT Executor {
 public:
  virtual ~Executor() = default;

  /// How many tiles can run at the same time, at least 1. Decides only how finely work is cut.
  [[nodiscard]] virtual int concurrency() const = 0;

  /// Calls task(tile) exactly once for every tile in [0, tiles), in any order, on any threads, and
  /// returns when all are done; all that the tiles wrote is then visible to the caller. Tiles do
  /// not wait for each other. What a tile throws, such as std::bad_alloc, must reach the caller.
  /// Where run() throws no tile may be running any more. Objects in several threads that share an
  /// executor call it at the same time.
  virtual void run(std::size_t tiles, TileTask task) = 0;
};

}  // namespace groundgrid
