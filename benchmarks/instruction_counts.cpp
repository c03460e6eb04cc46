// Runs each case with Callgrind counting the instructions of process() alone, and prints what was
// counted as lines of JSON. instruction_counts.py runs this and compares.
#include <hwy/targets.h>
#include <valgrind/callgrind.h>

#include <exception>
#include <iostream>

#include "drives.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid::benchmarks {
namespace {

/// An object of one thread whose instructions are counted where it is said.
class CountedGrid {
 public:
  void run(const TimedScan& scan) { grid_.process(scan.scan(), scan.T_map_lidar); }

  void count(const TimedScan& scan) {
    CALLGRIND_START_INSTRUMENTATION;
    run(scan);
    CALLGRIND_STOP_INSTRUMENTATION;
    points_ += scan.size();
    ++scans_;
  }

  void count_single(const TimedScan& scan) {
    CALLGRIND_START_INSTRUMENTATION;
    grid_.reset();
    grid_.process(scan.scan());
    CALLGRIND_STOP_INSTRUMENTATION;
    points_ += scan.size();
    ++scans_;
  }

  /// Callgrind writes what it has counted into a file that bears the name of the case.
  void report(const char* name) const {
    CALLGRIND_DUMP_STATS_AT(name);
    std::cout << R"({"case": ")" << name << R"(", "scans": )" << scans_ << R"(, "points": )"
              << points_ << "}\n";
  }

 private:
  static Config one_thread() {
    Config config;
    config.vehicle.sensor_height_m = 1.73;
    return config;
  }

  GroundGrid grid_{one_thread()};
  std::size_t scans_ = 0;
  std::size_t points_ = 0;
};

/// The last scan of the drive once more, into the map that the drive has left.
void warm(const char* name, const Drive& drive) {
  CountedGrid grid;
  for (const TimedScan& scan : drive.scans) grid.run(scan);
  grid.count(drive.scans.back());
  grid.report(name);
}

/// A single scan, the map forgotten before.
void cold(const char* name, const Drive& drive) {
  CountedGrid grid;
  for (const TimedScan& scan : drive.scans) grid.run(scan);
  grid.count_single(drive.scans.back());
  grid.report(name);
}

/// From end to end and back, counted on the way back.
void driving(const char* name, const Drive& drive) {
  CountedGrid grid;
  for (const TimedScan& scan : drive.scans) grid.run(scan);
  for (auto scan = drive.scans.rbegin() + 1; scan != drive.scans.rend(); ++scan) grid.count(*scan);
  grid.report(name);
}

void count_all() {
  std::cout << R"({"compiler": ")" << GROUNDGRID_COMPILER << R"(", "vectors": ")"
            << hwy::TargetName(hwy::SupportedAndGeneratedTargets().front()) << R"(", "data": ")"
            << drive().source << "\"}\n";
  warm("warm", drive());
  cold("cold", drive());
  driving("driving", drive());
  warm("warm, every fourth point", drive_of(k30));
  warm("warm, two scans in one", merged(drive(), 2));
}

}  // namespace
}  // namespace groundgrid::benchmarks

int main() {
  try {
    groundgrid::benchmarks::count_all();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
