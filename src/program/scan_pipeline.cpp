#include "program/scan_pipeline.hpp"

#include <cstddef>
#include <exception>
#include <utility>

#include "program/worker_thread.hpp"

namespace groundgrid::program {
namespace {

void read_or_note(const PipelineSteps& steps, const io::ScanFile& scan, ScanSlot& slot) {
  slot.problem = nullptr;
  try {
    steps.read(scan, slot);
  } catch (...) {
    slot.problem = std::current_exception();
  }
}

// The scan that is being written, if any.
class Writing {
 public:
  explicit Writing(const PipelineSteps& steps) : steps_(steps) {}

  void begin(const io::ScanFile& scan, ScanSlot& slot) {
    end();
    scan_ = &scan;
    slot_ = &slot;
    if (steps_.write) thread_.start([this, &scan, &slot] { steps_.write(scan, slot); });
  }

  void end() {
    if (scan_ == nullptr) return;
    const io::ScanFile& scan = *std::exchange(scan_, nullptr);
    thread_.wait();
    if (steps_.done) steps_.done(scan, *slot_);
  }

 private:
  const PipelineSteps& steps_;
  const io::ScanFile* scan_ = nullptr;
  ScanSlot* slot_ = nullptr;
  WorkerThread thread_;
};

}  // namespace

void ScanPipeline::run(std::span<const io::ScanFile> scans, const PipelineSteps& steps) {
  if (scans.empty()) return;
  Writing writing(steps);
  WorkerThread reading;
  const auto start_reading = [&](std::size_t i) {
    reading.start([&steps, &scan = scans[i], &slot = slots_[i % slots_.size()]] {
      read_or_note(steps, scan, slot);
    });
  };
  start_reading(0);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ScanSlot& slot = slots_[i % slots_.size()];
    reading.wait();
    // The slot of the next scan is free: what was in it two scans ago has been written.
    if (i + 1 < scans.size()) start_reading(i + 1);
    bool goes_on = false;
    try {
      goes_on = steps.process(scans[i], slot);
    } catch (...) {
      writing.end();
      throw;
    }
    if (goes_on)
      writing.begin(scans[i], slot);
    else
      writing.end();
  }
  writing.end();
}

}  // namespace groundgrid::program
