// Threads of the caller's own: the same bits whatever they do, and none that nobody asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <new>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"
#ifndef GROUNDGRID_STD_THREAD
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include "groundgrid/tbb_executor.hpp"
#endif

namespace groundgrid {
namespace {

using testing::DriveResult;
using testing::DriveScan;
using testing::run_drive;
using testing::same_bits;
using testing::street_drive;

/// Says that it runs `concurrency` tiles at a time and hands them to `run`.
class FunctionExecutor final : public Executor {
 public:
  using Run = std::function<void(std::size_t, TileTask)>;

  FunctionExecutor(int concurrency, Run run) : concurrency_(concurrency), run_(std::move(run)) {}

  [[nodiscard]] int concurrency() const override { return concurrency_; }
  void run(std::size_t tiles, TileTask task) override {
    ++runs_;
    run_(tiles, task);
  }

  [[nodiscard]] int runs() const { return runs_; }

 private:
  int concurrency_;
  Run run_;
  int runs_ = 0;
};

void run_forwards(std::size_t tiles, TileTask task) {
  for (std::size_t tile = 0; tile < tiles; ++tile) task(tile);
}

void run_backwards(std::size_t tiles, TileTask task) {
  while (tiles > 0) task(--tiles);
}

void run_shuffled(std::size_t tiles, TileTask task) {
  std::vector<std::size_t> order(tiles);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(static_cast<unsigned>(tiles)));
  for (const std::size_t tile : order) task(tile);
}

/// Every tile on a thread that is gone afterwards, eight at a time.
void run_on_many_threads(std::size_t tiles, TileTask task) {
  for (std::size_t first = 0; first < tiles; first += 8) {
    std::vector<std::thread> threads;
    for (std::size_t tile = first; tile < std::min(first + 8, tiles); ++tile)
      threads.emplace_back([=] { task(tile); });
    for (std::thread& thread : threads) thread.join();
  }
}

/// None of the tiles on the thread that calls.
void run_elsewhere(std::size_t tiles, TileTask task) {
  std::thread([=] { run_forwards(tiles, task); }).join();
}

void expect_same_bits_by(FunctionExecutor executor, const Config& config,
                         const std::vector<DriveScan>& drive, const DriveResult& expected) {
  GroundGrid grid(config, executor);
  EXPECT_TRUE(same_bits(run_drive(grid, drive), expected))
      << executor.concurrency() << " at a time";
  // The other methods are pages that run on the thread that calls.
  EXPECT_EQ(executor.runs() > 0, config.method == Method::standard);
}

void expect_same_bits_by_any(const Config& config) {
  const std::vector<DriveScan> drive = street_drive(3);
  const DriveResult expected = run_drive(config, drive);
  expect_same_bits_by({2, run_forwards}, config, drive, expected);
  expect_same_bits_by({64, run_forwards}, config, drive, expected);
  expect_same_bits_by({3, run_backwards}, config, drive, expected);
  expect_same_bits_by({5, run_shuffled}, config, drive, expected);
  expect_same_bits_by({8, run_on_many_threads}, config, drive, expected);
  expect_same_bits_by({2, run_elsewhere}, config, drive, expected);
}

TEST(Executor, GivesTheSameBitsInAnyOrderOnAnyThreads) {
  expect_same_bits_by_any(Config{});
  expect_same_bits_by_any(Config::paper());
}

TEST(Executor, OfOneThreadIsNotAskedToRunAnything) {
  FunctionExecutor executor(1, run_forwards);
  GroundGrid grid(Config{}, executor);
  run_drive(grid, street_drive(2));
  EXPECT_EQ(executor.runs(), 0);
}

TEST(Executor, MayServeSeveralObjectsAndObjectsThatMove) {
  const std::vector<DriveScan> drive = street_drive(2);
  const DriveResult expected = run_drive(Config{}, drive);
  FunctionExecutor executor(4, run_backwards);
  GroundGrid first(Config{}, executor);
  GroundGrid second(Config{}, executor);
  const GroundGrid gone = std::move(second);
  second = std::move(first);
  EXPECT_TRUE(same_bits(run_drive(second, drive), expected));
}

TEST(Executor, OfNoThreadIsRefused) {
  for (const int concurrency : {0, -1}) {
    FunctionExecutor executor(concurrency, run_forwards);
    EXPECT_THROW(GroundGrid(Config{}, executor), std::invalid_argument);
  }
  FunctionExecutor executor(2, run_forwards);
  Config config;
  config.map.resolution_m = -1.0;
  EXPECT_THROW(GroundGrid(config, executor), std::invalid_argument);
}

TEST(Executor, ThatThrowsEndsTheObject) {
  const std::vector<DriveScan> drive = street_drive(2);
  bool works = true;
  FunctionExecutor executor(4, [&](std::size_t tiles, TileTask task) {
    if (!works) throw std::runtime_error("no threads left");
    run_forwards(tiles, task);
  });
  GroundGrid grid(Config{}, executor);
  grid.process(drive[0].scan(), drive[0].T_map_base);
  works = false;
  EXPECT_THROW(grid.process(drive[1].scan(), drive[1].T_map_base), std::runtime_error);
  works = true;
  EXPECT_THROW(grid.process(drive[1].scan(), drive[1].T_map_base), std::logic_error);
  grid.reset();
  EXPECT_THROW(grid.process(drive[1].scan(), drive[1].T_map_base), std::logic_error);
  grid = GroundGrid(Config{}, executor);
  EXPECT_TRUE(same_bits(run_drive(grid, drive), run_drive(Config{}, drive)));
}

TEST(Executor, IsLeftAloneByScansThatAreRefused) {
  const std::vector<DriveScan> drive = street_drive(1);
  FunctionExecutor executor(4, run_forwards);
  GroundGrid grid(Config{}, executor);
  Eigen::Isometry3d nowhere = Eigen::Isometry3d::Identity();
  nowhere.translation().x() = 1e10;
  EXPECT_THROW(grid.process(drive[0].scan(), nowhere), std::invalid_argument);
  EXPECT_EQ(executor.runs(), 0);
  EXPECT_TRUE(same_bits(run_drive(grid, drive), run_drive(Config{}, drive)));
}

std::size_t threads_of_this_program() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

TEST(OneThread, IsCounted) {
  const std::size_t before = threads_of_this_program();
  std::mutex mutex;
  std::condition_variable changed;
  bool counted = false;
  std::thread other([&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return counted; });
  });
  // ThreadSanitizer starts one of its own together with the first.
  EXPECT_GT(threads_of_this_program(), before);
  {
    const std::lock_guard lock(mutex);
    counted = true;
  }
  changed.notify_one();
  other.join();
}

// Those that oneTBB starts stay until the program ends.
TEST(OneThread, StartsNoOther) {
  const std::size_t before = threads_of_this_program();
  GroundGrid grid(Config{}, 1);
  run_drive(grid, street_drive(2));
  EXPECT_FALSE(grid.standard_deviation().empty());
  EXPECT_EQ(threads_of_this_program(), before);
}

#ifndef GROUNDGRID_STD_THREAD
/// Hands on to a TbbExecutor and counts the tiles by the number of threads of the arena they ran
/// in. An observer of the arena would be simpler, but oneTBB leaks it where threads are still there
/// when the program ends.
class WatchedArena final : public Executor {
 public:
  explicit WatchedArena(oneapi::tbb::task_arena& arena)
      : executor_(arena), slots_(arena.max_concurrency()) {}

  [[nodiscard]] int concurrency() const override { return executor_.concurrency(); }
  void run(std::size_t tiles, TileTask task) override {
    const auto watched = [this, task](std::size_t tile) {
      ++(oneapi::tbb::this_task_arena::max_concurrency() == slots_ ? inside_ : outside_);
      task(tile);
    };
    executor_.run(tiles, TileTask(watched));
  }

  [[nodiscard]] int inside() const { return inside_; }
  [[nodiscard]] int outside() const { return outside_; }

 private:
  TbbExecutor executor_;
  int slots_;
  std::atomic<int> inside_{0};
  std::atomic<int> outside_{0};
};

TEST(TbbExecutor, GivesTheSameBitsInTheArenaOfTheCaller) {
  const std::vector<DriveScan> drive = street_drive(3);
  const DriveResult expected = run_drive(Config{}, drive);
  // More threads than the machine may have cores.
  const oneapi::tbb::global_control enough(oneapi::tbb::global_control::max_allowed_parallelism, 8);
  for (const int slots : {2, 4, 7}) {
    oneapi::tbb::task_arena arena(slots);
    WatchedArena executor(arena);
    EXPECT_EQ(executor.concurrency(), slots);
    GroundGrid grid(Config{}, executor);
    EXPECT_EQ(executor.inside(), 0);
    EXPECT_TRUE(same_bits(run_drive(grid, drive), expected)) << slots << " slots";
    EXPECT_GT(executor.inside(), 0) << slots << " slots";
    EXPECT_EQ(executor.outside(), 0) << slots << " slots";
  }
}

TEST(TbbExecutor, LeavesAnArenaOfOneThreadAlone) {
  const std::vector<DriveScan> drive = street_drive(2);
  oneapi::tbb::task_arena arena(1);
  WatchedArena executor(arena);
  GroundGrid grid(Config{}, executor);
  EXPECT_TRUE(same_bits(run_drive(grid, drive), run_drive(Config{}, drive)));
  EXPECT_EQ(executor.inside() + executor.outside(), 0);
}

TEST(TbbExecutor, HandsOnWhatATileThrows) {
  oneapi::tbb::task_arena arena(2);
  TbbExecutor executor(arena);
  const auto throws = [](std::size_t tile) {
    if (tile == 3) throw std::bad_alloc();
  };
  EXPECT_THROW(executor.run(8, TileTask(throws)), std::bad_alloc);
}
#endif

}  // namespace
}  // namespace groundgrid
