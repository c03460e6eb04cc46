#include "program/scan_choice.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"

namespace groundgrid::program {
namespace {

TEST(ScanWords, NameSequenceAndScan) {
  const io::ScanFile scan{.name = "000040", .path = "000040.bin"};
  EXPECT_EQ(words_of({.name = "01", .folder = "nowhere"}, scan), "sequence 01, scan 000040");
  EXPECT_EQ(words_of({.name = "", .folder = "nowhere"}, scan), "scan 000040");
}

TEST(ScanWords, SayWhatIsSimulated) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "truth" / "drive.json", "{}");
  EXPECT_EQ(
      words_of({.name = "00", .folder = folder.path()}, {.name = "000001", .path = "000001.bin"}),
      "simulated sequence 00, scan 000001");
}

}  // namespace
}  // namespace groundgrid::program
