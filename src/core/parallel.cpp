#include "core/parallel.hpp"

#include <algorithm>
#include <thread>

namespace groundgrid {

TileRunner::TileRunner(int threads)
    : threads_(threads > 0 ? threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {
#ifndef GROUNDGRID_STD_THREAD
  if (threads_ > 1) arena_ = std::make_unique<oneapi::tbb::task_arena>(threads_);
#endif
}

}  // namespace groundgrid
