#include "program/scan_pipeline.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace groundgrid::program {
namespace {

using namespace std::chrono_literals;
using Numbers = std::vector<std::size_t>;

std::vector<io::ScanFile> numbered_scans(std::size_t count) {
  std::vector<io::ScanFile> scans(count);
  for (std::size_t i = 0; i < count; ++i) scans[i].number = i;
  return scans;
}

// Notes which scans each step saw. A slot's milliseconds carry the number of the scan in it.
struct Notes {
  Numbers read, processed, written, done;

  PipelineSteps steps() {
    return {.read =
                [this](const io::ScanFile& scan, ScanSlot& slot) {
                  slot.milliseconds = static_cast<double>(scan.number);
                  read.push_back(scan.number);
                },
            .process =
                [this](const io::ScanFile& scan, ScanSlot& slot) {
                  if (slot.problem) std::rethrow_exception(slot.problem);
                  EXPECT_EQ(slot.milliseconds, static_cast<double>(scan.number));
                  processed.push_back(scan.number);
                  return true;
                },
            .write =
                [this](const io::ScanFile& scan, ScanSlot& slot) {
                  EXPECT_EQ(slot.milliseconds, static_cast<double>(scan.number));
                  written.push_back(scan.number);
                },
            .done =
                [this](const io::ScanFile& scan, ScanSlot& slot) {
                  EXPECT_EQ(slot.milliseconds, static_cast<double>(scan.number));
                  done.push_back(scan.number);
                }};
  }
};

TEST(ScanPipeline, KeepsTheOrderInEveryStep) {
  const auto scans = numbered_scans(20);
  Notes notes;
  ScanPipeline().run(scans, notes.steps());
  Numbers all;
  for (const io::ScanFile& scan : scans) all.push_back(scan.number);
  EXPECT_EQ(notes.read, all);
  EXPECT_EQ(notes.processed, all);
  EXPECT_EQ(notes.written, all);
  EXPECT_EQ(notes.done, all);
}

TEST(ScanPipeline, DoesNothingWithoutScans) {
  Notes notes;
  ScanPipeline().run({}, notes.steps());
  EXPECT_EQ(notes.read, Numbers{});
}

TEST(ScanPipeline, ReadsOnOneThreadAndWritesOnAnother) {
  std::set<std::thread::id> reading;
  std::set<std::thread::id> writing;
  PipelineSteps steps;
  steps.read = [&](const io::ScanFile& /*scan*/, ScanSlot& /*slot*/) {
    reading.insert(std::this_thread::get_id());
  };
  steps.process = [](const io::ScanFile& /*scan*/, ScanSlot& /*slot*/) { return true; };
  steps.write = [&](const io::ScanFile& /*scan*/, ScanSlot& /*slot*/) {
    writing.insert(std::this_thread::get_id());
  };
  ScanPipeline().run(numbered_scans(10), steps);
  EXPECT_EQ(reading.size(), 1U);
  EXPECT_EQ(writing.size(), 1U);
  EXPECT_NE(reading, writing);
  EXPECT_FALSE(reading.contains(std::this_thread::get_id()));
  EXPECT_FALSE(writing.contains(std::this_thread::get_id()));
}

TEST(ScanPipeline, ReadsTheNextScanAndWritesTheLastWhileOneIsProcessed) {
  const auto scans = numbered_scans(3);
  Notes notes;
  PipelineSteps steps = notes.steps();
  // Scan 1 is held in process until scan 2 is being read, and in write until then too.
  std::promise<void> reads_two;
  std::promise<void> processes_one;
  const auto two_is_read = reads_two.get_future().share();
  const auto one_is_processed = processes_one.get_future().share();
  steps.read = [&](const io::ScanFile& scan, ScanSlot& /*slot*/) {
    if (scan.number == 2) reads_two.set_value();
  };
  steps.process = [&](const io::ScanFile& scan, ScanSlot& /*slot*/) {
    if (scan.number == 1) {
      processes_one.set_value();
      EXPECT_EQ(two_is_read.wait_for(20s), std::future_status::ready);
    }
    return true;
  };
  steps.write = [&](const io::ScanFile& scan, ScanSlot& /*slot*/) {
    if (scan.number > 0) return;
    EXPECT_EQ(one_is_processed.wait_for(20s), std::future_status::ready);
  };
  steps.done = {};
  ScanPipeline().run(scans, steps);
}

TEST(ScanPipeline, HandsAReadingProblemToItsScan) {
  const auto scans = numbered_scans(5);
  Notes notes;
  PipelineSteps steps = notes.steps();
  steps.read = [read = steps.read](const io::ScanFile& scan, ScanSlot& slot) {
    if (scan.number == 2) throw std::runtime_error("cut short");
    read(scan, slot);
  };
  std::string problem;
  steps.process = [&, process = steps.process](const io::ScanFile& scan, ScanSlot& slot) {
    try {
      return process(scan, slot);
    } catch (const std::runtime_error& error) {
      problem = error.what() + std::to_string(scan.number);
      return false;
    }
  };
  ScanPipeline().run(scans, steps);
  EXPECT_EQ(problem, "cut short2");
  EXPECT_EQ(notes.done, (Numbers{0, 1, 3, 4}));
}

TEST(ScanPipeline, FinishesTheScansBeforeTheOneThatFails) {
  const auto scans = numbered_scans(8);
  Notes notes;
  PipelineSteps steps = notes.steps();
  steps.process = [](const io::ScanFile& scan, ScanSlot& /*slot*/) -> bool {
    if (scan.number == 4) throw std::runtime_error("no pose");
    return true;
  };
  EXPECT_THROW(ScanPipeline().run(scans, steps), std::runtime_error);
  EXPECT_EQ(notes.written, (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(notes.done, (Numbers{0, 1, 2, 3}));
}

TEST(ScanPipeline, EndsWhereWritingFails) {
  const auto scans = numbered_scans(8);
  Notes notes;
  PipelineSteps steps = notes.steps();
  steps.write = [](const io::ScanFile& scan, ScanSlot& /*slot*/) {
    if (scan.number == 3) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(ScanPipeline().run(scans, steps), std::runtime_error);
  EXPECT_EQ(notes.done, (Numbers{0, 1, 2}));
}

// A scan that is passed over must not let a later one into the slot that is still being written.
TEST(ScanPipeline, KeepsASlotUntilItIsWritten) {
  const auto scans = numbered_scans(12);
  Notes notes;
  PipelineSteps steps = notes.steps();
  steps.process = [](const io::ScanFile& scan, ScanSlot& /*slot*/) { return scan.number % 3 == 0; };
  steps.write = [write = steps.write](const io::ScanFile& scan, ScanSlot& slot) {
    std::this_thread::sleep_for(5ms);
    write(scan, slot);
  };
  ScanPipeline().run(scans, steps);
  EXPECT_EQ(notes.done, (Numbers{0, 3, 6, 9}));
}

}  // namespace
}  // namespace groundgrid::program
