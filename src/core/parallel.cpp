#include "core/parallel.hpp"

#include <algorithm>
#include <thread>

#ifndef GROUNDGRID_STD_THREAD
#include <oneapi/tbb/info.h>
#endif

namespace groundgrid {

TileRunner::TileRunner(int threads)
    : threads_(threads > 0 ? threads
                           : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {
#ifndef GROUNDGRID_STD_THREAD
  // More slots than cores bring nothing, and oneTBB would write a warning to standard error.
  const int slots = std::min(threads_, oneapi::tbb::info::default_concurrency());
  if (threads_ > 1) arena_ = std::make_unique<oneapi::tbb::task_arena>(slots);
#endif
}

}  // namespace groundgrid
