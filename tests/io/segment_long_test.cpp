// Memory and interruption: runs that are watched from outside.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <tuple>

#include "oversized_file.hpp"
#include "sanitized.hpp"
#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::contains;
using test::files_below;
using test::Names;
using test::ProgramRun;
using test::Segment;

// Runs that the test watches from outside: many scans, all of them one file.
class LongRun : public Segment {
 protected:
  void add_scans(std::size_t scans, std::size_t step_m = 0) const {
    dataset.add_sequence("00", 1);
    std::string poses;
    for (std::size_t i = 0; i < scans; ++i) {
      if (i > 0) fs::create_symlink(dataset.scan_file("00", 0), dataset.scan_file("00", i));
      poses += "1 0 0 0 0 1 0 0 0 0 1 " + std::to_string(i * step_m) + "\n";
    }
    test::write_file(dataset.folder / "sequences/00/poses.txt", poses);
  }

  // With one flag more, or none.
  [[nodiscard]] pid_t start(const char* flag = nullptr) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, STDERR_FILENO);
    ::execl(GROUNDGRID_EXECUTABLE, "groundgrid", "segment", dataset.path().c_str(), "--output",
            output().c_str(), flag, static_cast<char*>(nullptr));
    ::_exit(127);
  }
};

#if !defined(GROUNDGRID_SANITIZED)
TEST_F(Segment, SkipsAScanThatMemoryDoesNotHold) {
  dataset.add_sequence("00", 2);
  test::make_sparse_file(dataset.scan_file("00", 0), std::uintmax_t{16} << 30U);
  const std::string little_memory = "ulimit -v 4000000; ";
  const ProgramRun run = segment("", little_memory);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.words, dataset.scan_file("00", 0).string()));
  ASSERT_EQ(segment("--keep-going", little_memory).exit_code, 0);
  EXPECT_EQ(record()["sequences"][0]["skipped"][0]["file"], dataset.scan_file("00", 0).string());
}

TEST_F(Segment, SaysWhichParametersMakeTheMapTooLarge) {
  dataset.add_sequence("00", 1);
  for (const std::string more : {"", " --keep-going"}) {
    const ProgramRun run =
        segment("--resolution-m 0.04 --extent-m 160" + more, "ulimit -v 1000000; ");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_TRUE(contains(run.words, "4000 x 4000 cells (extent_m = 160, resolution_m = 0.04)"));
    EXPECT_TRUE(contains(run.words, "about 2400 MB"));
  }
}

class MemoryOfALongRun : public LongRun {
 protected:
  [[nodiscard]] long peak_kilobytes(std::size_t scans, std::size_t step_m, const char* flag) const {
    fs::remove_all(dataset.folder / "sequences");
    add_scans(scans, step_m);
    rusage usage{};
    int status = 0;
    EXPECT_GT(::wait4(start(flag), &status, 0, &usage), 0);
    EXPECT_EQ(status, 0);
    return usage.ru_maxrss;
  }
};

TEST_F(MemoryOfALongRun, StaysFlat) {
  const long few = peak_kilobytes(5, 0, nullptr);
  const long many = peak_kilobytes(200, 0, nullptr);
  EXPECT_LT(many, 150'000);
  EXPECT_LT(many, few + 2'000);
}

// Two kilometres; the terrain behind the vehicle is on disk.
TEST_F(MemoryOfALongRun, StaysFlatWithTerrain) {
  const long few = peak_kilobytes(20, 10, "--terrain");
  const long many = peak_kilobytes(200, 10, "--terrain");
  EXPECT_LT(many, 300'000);
  EXPECT_LT(many, few + 30'000);
}
#endif

class Interrupted : public LongRun,
                    public ::testing::WithParamInterface<std::tuple<int, const char*>> {};

TEST_P(Interrupted, EndsInGoodOrder) {
  add_scans(5000);
  const auto [signal, flag] = GetParam();
  const pid_t child = start(flag);
  while (!fs::exists(output() / "sequences/00/predictions/000002.label"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const Names files = files_below(output());
  EXPECT_LT(files.size(), 5000U);
  EXPECT_FALSE(fs::exists(output() / "run.json"));
  const auto bytes = test::SyntheticScan().size() * sizeof(std::uint32_t);
  for (const std::string& file : files) {
    if (file == "timing.csv") continue;
    EXPECT_EQ(fs::file_size(output() / file), bytes) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted,
                         ::testing::Combine(::testing::Values(SIGINT, SIGTERM, SIGHUP),
                                            ::testing::Values(nullptr, "--terrain")));

}  // namespace
}  // namespace groundgrid::program
