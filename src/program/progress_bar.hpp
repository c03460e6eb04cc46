#pragma once

#include <spdlog/sinks/sink.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace groundgrid::program {

/// "[=====>    ]  123/4541  182.4 scans/s  0:24 left": what the bar shows after `done` of `all`
/// scans in `seconds`.
std::string progress_line(std::size_t done, std::size_t all, double seconds);

/// A progress bar on standard error where that is a terminal; elsewhere nothing at all. Words that
/// are logged while it is there stand above it.
class ProgressBar {
 public:
  explicit ProgressBar(std::size_t scans);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ProgressBar(ProgressBar&&) = delete;
  ProgressBar& operator=(ProgressBar&&) = delete;

  /// One scan more is done, or passed over.
  void advance();

 private:
  using Clock = std::chrono::steady_clock;

  void draw() const;

  bool shown_;
  std::size_t scans_;
  std::size_t done_ = 0;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point drawn_{};
  std::vector<spdlog::sink_ptr> sinks_before_{};
};

}  // namespace groundgrid::program
