#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstddef>

#include "groundgrid/executor.hpp"

namespace groundgrid {

/// Runs tiles in an arena of the caller's, which must outlive this object: with the arena's number
/// of threads, priority and NUMA node. Who includes this header links TBB::tbb.
class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(oneapi::tbb::task_arena& arena) : arena_(&arena) {}

  [[nodiscard]] int concurrency() const override { return arena_->max_concurrency(); }

  /// Threads that wait for tiles take no other work of the arena meanwhile.
  void run(std::size_t tiles, TileTask task) override {
    arena_->execute([=] {
      oneapi::tbb::this_task_arena::isolate([=] {
        oneapi::tbb::parallel_for(std::size_t{0}, tiles, task, oneapi::tbb::simple_partitioner{});
      });
    });
  }

 private:
  oneapi::tbb::task_arena* arena_;
};

}  // namespace groundgrid
