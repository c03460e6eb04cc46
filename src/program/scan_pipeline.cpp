#include "program/scan_pipeline.hpp"

#include <cstddef>
#include <exception>
#include <future>
#include <utility>

namespace groundgrid::program {
namespace {

std::future<void> start(const PipelineSteps::Step& step, const io::ScanFile& scan, ScanSlot& slot) {
  return std::async(std::launch::async, [&step, &scan, &slot] { step(scan, slot); });
}

std::future<void> start_reading(const PipelineSteps& steps, const io::ScanFile& scan,
                                ScanSlot& slot) {
  return std::async(std::launch::async, [&steps, &scan, &slot] {
    slot.problem = nullptr;
    try {
      steps.read(scan, slot);
    } catch (...) {
      slot.problem = std::current_exception();
    }
  });
}

// The scan that is being written, if any.
class Writing {
 public:
  explicit Writing(const PipelineSteps& steps) : steps_(steps) {}

  void begin(const io::ScanFile& scan, ScanSlot& slot) {
    end();
    scan_ = &scan;
    slot_ = &slot;
    written_ = steps_.write ? start(steps_.write, scan, slot) : std::future<void>{};
  }

  void end() {
    if (scan_ == nullptr) return;
    const io::ScanFile& scan = *std::exchange(scan_, nullptr);
    if (written_.valid()) written_.get();
    if (steps_.done) steps_.done(scan, *slot_);
  }

 private:
  const PipelineSteps& steps_;
  const io::ScanFile* scan_ = nullptr;
  ScanSlot* slot_ = nullptr;
  std::future<void> written_;
};

}  // namespace

void ScanPipeline::run(std::span<const io::ScanFile> scans, const PipelineSteps& steps) {
  if (scans.empty()) return;
  Writing writing(steps);
  std::future<void> reading = start_reading(steps, scans.front(), slots_.front());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ScanSlot& slot = slots_[i % slots_.size()];
    reading.get();
    // The slot of the next scan is free: what was in it two scans ago has been written.
    if (i + 1 < scans.size())
      reading = start_reading(steps, scans[i + 1], slots_[(i + 1) % slots_.size()]);
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
