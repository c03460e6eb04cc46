#include "core/parallel.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>

#ifdef GROUNDGRID_STD_THREAD
#include <atomic>
#include <vector>
#else
#include <oneapi/tbb/info.h>

#include "groundgrid/tbb_executor.hpp"
#endif

namespace groundgrid {
namespace {

#ifdef GROUNDGRID_STD_THREAD
// A stock libtbb is not built for ThreadSanitizer, which then reports races that are none; the
// tsan build runs the same tiles on threads that it can follow.
class OwnThreads final : public Executor {
 public:
  explicit OwnThreads(int threads) : threads_(threads) {}

  [[nodiscard]] int concurrency() const override { return threads_; }

  void run(std::size_t tiles, TileTask task) override {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t tile = next++; tile < tiles; tile = next++) task(tile);
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < threads_; ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
  }

 private:
  int threads_;
};
#else
class OwnThreads final : public Executor {
 public:
  // More slots than cores bring nothing, and oneTBB would write a warning to standard error.
  explicit OwnThreads(int threads)
      : arena_(std::min(threads, oneapi::tbb::info::default_concurrency())) {}

  [[nodiscard]] int concurrency() const override { return in_arena_.concurrency(); }
  void run(std::size_t tiles, TileTask task) override { in_arena_.run(tiles, task); }

 private:
  oneapi::tbb::task_arena arena_;
  TbbExecutor in_arena_{arena_};
};
#endif

int at_least_one(int concurrency) {
  if (concurrency < 1)
    throw std::invalid_argument("Executor::concurrency(): " + std::to_string(concurrency) +
                                "; expected at least 1");
  return concurrency;
}

int threads_from(int wanted) {
  constexpr int kMost = 1024;
  if (wanted < 0 || wanted > kMost)
    throw std::invalid_argument("threads = " + std::to_string(wanted) +
                                ": must be between 0 (one per core) and 1024");
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

TileRunner::TileRunner(int threads) : threads_(threads_from(threads)) {
  if (threads_ == 1) return;
  own_ = std::make_unique<OwnThreads>(threads_);
  executor_ = own_.get();
}

TileRunner::TileRunner(Executor& executor)
    : threads_(at_least_one(executor.concurrency())), executor_(&executor) {}

}  // namespace groundgrid
