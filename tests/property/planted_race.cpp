// Tiles that all write what none of them owns: ThreadSanitizer must report it.
#include <cstdio>

#include "core/parallel.hpp"

int main() {
  groundgrid::TileRunner runner(2);
  int unowned = 0;
  runner.parallel_for_tiles(1000, [&](std::size_t) { ++unowned; });
  std::printf("%d\n", unowned);
}
