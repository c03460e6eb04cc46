#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#ifdef GROUNDGRID_STD_THREAD
#include <atomic>
#include <thread>
#include <vector>
#else
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace groundgrid {

/// The one place where threads come in. A stage cuts its work into tiles that each own what they
/// write; which thread takes which tile, and how many there are, then cannot change a bit.
class TileRunner {
 public:
  /// `threads` of 0 means one per core.
  explicit TileRunner(int threads);

  [[nodiscard]] int threads() const { return threads_; }

  /// Calls task(tile) once for every tile in [0, tiles) and returns when all are done.
  template <typename Task>
  void parallel_for_tiles(std::size_t tiles, const Task& task) {
    if (threads_ == 1 || tiles < 2) {
      for (std::size_t tile = 0; tile < tiles; ++tile) task(tile);
      return;
    }
    run(tiles, task);
  }

  /// Calls task(begin, end) for pieces of [0, count) of at most `per_tile` indices.
  template <typename Task>
  void parallel_for_ranges(std::size_t count, std::size_t per_tile, const Task& task) {
    parallel_for_tiles((count + per_tile - 1) / per_tile, [&](std::size_t tile) {
      task(tile * per_tile, std::min((tile + 1) * per_tile, count));
    });
  }

 private:
#ifdef GROUNDGRID_STD_THREAD
  // A stock libtbb is not built for ThreadSanitizer, which then reports races that are none; the
  // tsan build runs the same tiles on threads that it can follow.
  template <typename Task>
  void run(std::size_t tiles, const Task& task) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t tile = next++; tile < tiles; tile = next++) task(tile);
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < threads_; ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
  }
#else
  template <typename Task>
  void run(std::size_t tiles, const Task& task) {
    arena_->execute([&] {
      oneapi::tbb::parallel_for(std::size_t{0}, tiles, task, oneapi::tbb::simple_partitioner{});
    });
  }

  std::unique_ptr<oneapi::tbb::task_arena> arena_;
#endif

  int threads_ = 1;
};

}  // namespace groundgrid
