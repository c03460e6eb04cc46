#include "program/progress_bar.hpp"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "segment_fixture.hpp"

namespace groundgrid::program {
namespace {

using test::contains;
using test::Segment;

TEST(ProgressLine, ShowsShareRateAndRemainingTime) {
  EXPECT_EQ(progress_line(25, 100, 5.0),
            "[=======>                      ]  25/100  5.0 scans/s  0:15 left");
  EXPECT_EQ(progress_line(100, 100, 5.0),
            "[==============================] 100/100  20.0 scans/s  0:00 left");
}

TEST(ProgressLine, CountsHours) {
  EXPECT_TRUE(contains(progress_line(10, 72010, 10.0), "1.0 scans/s  20:00:00 left"));
}

TEST(ProgressLine, PromisesNothingBeforeTheFirstScan) {
  EXPECT_EQ(progress_line(0, 9, 0.0), "[>                             ] 0/9  0.0 scans/s  ");
}

// What the program writes where its standard error is a terminal.
std::string words_on_a_terminal(const std::filesystem::path& dataset,
                                const std::filesystem::path& output) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::execl(GROUNDGRID_EXECUTABLE, "groundgrid", "segment", dataset.c_str(), "--output",
            output.c_str(), "--keep-going", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  std::string words;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = ::read(terminal, buffer.data(), buffer.size())) > 0;)
    words.append(buffer.data(), static_cast<std::size_t>(got));
  ::waitpid(child, nullptr, 0);
  ::close(terminal);
  return words;
}

TEST_F(Segment, ShowsProgressOnATerminalOnly) {
  dataset.add_sequence("00", 3);
  std::filesystem::resize_file(dataset.scan_file("00", 1), 100);
  const std::string words = words_on_a_terminal(dataset.path(), output());
  EXPECT_TRUE(contains(words, "3/3"));
  EXPECT_TRUE(contains(words, "scans/s"));
  // The warning begins a line of its own: the bar is cleared before it.
  const auto warning = words.find("skipped: ");
  ASSERT_NE(warning, std::string::npos);
  const auto cleared = words.rfind("\r\x1b[K", warning);
  ASSERT_NE(cleared, std::string::npos);
  EXPECT_EQ(words.substr(cleared, warning - cleared).find("scans/s"), std::string::npos);
  EXPECT_EQ(segment("--keep-going").words.find("scans/s"), std::string::npos);
}

}  // namespace
}  // namespace groundgrid::program
