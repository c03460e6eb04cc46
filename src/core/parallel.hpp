#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "groundgrid/executor.hpp"

namespace groundgrid {

/// Cells that a thread takes at a time: enough to be worth it, few enough to share out evenly.
inline constexpr std::size_t kCellsPerTile = 1024;

/// The one place where threads come in. A stage cuts its work into tiles that each own what they
/// write; which thread takes which tile, and how many there are, then cannot change a bit.
class TileRunner {
 public:
  /// `threads` of 0 means one per core. With one thread none is started, and oneTBB not called.
  /// Throws std::invalid_argument if it is not in [0, 1024].
  explicit TileRunner(int threads);

  /// Runs on the threads of an executor that outlives this object. Throws std::invalid_argument
  /// where its concurrency is less than 1.
  explicit TileRunner(Executor& executor);

  [[nodiscard]] int threads() const { return threads_; }

  /// Calls task(tile) once for every tile in [0, tiles) and returns when all are done.
  template <typename Task>
  void parallel_for_tiles(std::size_t tiles, const Task& task) {
    if (threads_ == 1 || tiles < 2) {
      for (std::size_t tile = 0; tile < tiles; ++tile) task(tile);
      return;
    }
    executor_->run(tiles, TileTask(task));
  }

  /// Calls task(begin, end) for pieces of [0, count) of at most `per_tile` indices.
  template <typename Task>
  void parallel_for_ranges(std::size_t count, std::size_t per_tile, const Task& task) {
    parallel_for_tiles((count + per_tile - 1) / per_tile, [&](std::size_t tile) {
      task(tile * per_tile, std::min((tile + 1) * per_tile, count));
    });
  }

 private:
  int threads_;
  std::unique_ptr<Executor> own_;
  Executor* executor_ = nullptr;
};

}  // namespace groundgrid
