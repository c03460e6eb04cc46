// Tiles that all write what none of them owns: ThreadSanitizer must report it.
#include <array>
#include <atomic>
#include <cstdio>

#include "core/parallel.hpp"

int main() {
  groundgrid::TileRunner runner(2);
  std::array<int, 1000> unowned{};
  // The tiles wait for each other, so that two threads must take one each: a quick thread could
  // take both, and where only one writes there is no race to report. A relaxed count orders
  // nothing between them. They write in opposite directions, since two writes to one place in the
  // very same moment can escape the sanitizer.
  std::atomic<int> arrived{0};
  runner.parallel_for_tiles(2, [&](std::size_t tile) {
    arrived.fetch_add(1, std::memory_order_relaxed);
    while (arrived.load(std::memory_order_relaxed) < 2) {
    }
    for (std::size_t i = 0; i < unowned.size(); ++i)
      ++unowned[tile == 0 ? i : unowned.size() - 1 - i];
  });
  std::printf("%d\n", unowned.front());
}
