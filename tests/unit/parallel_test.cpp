#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace groundgrid {
namespace {

TEST(TileRunner, RunsEveryTileOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    TileRunner runner(threads);
    EXPECT_EQ(runner.threads(), threads);
    for (const std::size_t tiles : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<int> runs(tiles);
      runner.parallel_for_tiles(tiles, [&](std::size_t tile) { ++runs[tile]; });
      EXPECT_EQ(runs, std::vector<int>(tiles, 1)) << threads << " threads";
    }
  }
}

TEST(TileRunner, NoThreadsMeansOnePerCore) { EXPECT_GE(TileRunner(0).threads(), 1); }

TEST(TileRunner, HandsOnWhatTheTilesHaveWritten) {
  TileRunner runner(4);
  std::vector<int> values(5000);
  runner.parallel_for_tiles(values.size(), [&](std::size_t tile) { values[tile] = 3; });
  EXPECT_EQ(std::accumulate(values.begin(), values.end(), 0), 15000);
}

}  // namespace
}  // namespace groundgrid
