#include "program/timing_table.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::program {
namespace {

using test::read_file;

constexpr const char* kHeader = "sequence,scan,points,milliseconds\n";

void write(const std::filesystem::path& path, const std::vector<TimingRow>& rows) {
  TimingTable table(path);
  for (const TimingRow& row : rows) table.add(row);
  table.write();
}

TEST(TimingTable, HasAHeaderAndARowPerScan) {
  const test::TemporaryFolder folder;
  write(folder / "t.csv", {{"00", "000000", 120000, 4.5}, {"00", "000001", 7, 0.25}});
  EXPECT_EQ(read_file(folder / "t.csv"),
            std::string(kHeader) + "00,000000,120000,4.500\n00,000001,7,0.250\n");
}

TEST(TimingTable, KeepsOtherSequencesAndReplacesItsOwn) {
  const test::TemporaryFolder folder;
  write(folder / "t.csv", {{"00", "000000", 1, 1.0}, {"00", "000001", 1, 1.0}});
  write(folder / "t.csv", {{"03", "000000", 3, 3.0}});
  write(folder / "t.csv", {{"00", "000000", 2, 2.0}});
  EXPECT_EQ(read_file(folder / "t.csv"),
            std::string(kHeader) + "00,000000,2,2.000\n03,000000,3,3.000\n");
}

TEST(TimingTable, ReplacesPlainFilesOneByOne) {
  const test::TemporaryFolder folder;
  write(folder / "t.csv", {{"", "a", 1, 1.0}, {"", "b", 1, 1.0}});
  write(folder / "t.csv", {{"", "b", 2, 2.0}});
  EXPECT_EQ(read_file(folder / "t.csv"), std::string(kHeader) + ",a,1,1.000\n,b,2,2.000\n");
}

TEST(TimingTable, QuotesNames) {
  const test::TemporaryFolder folder;
  write(folder / "t.csv", {{"", "a,\"b\"", 1, 1.0}, {"", "c", 1, 1.0}});
  write(folder / "t.csv", {{"", "a,\"b\"", 2, 2.0}});
  EXPECT_EQ(read_file(folder / "t.csv"),
            std::string(kHeader) + ",\"a,\"\"b\"\"\",2,2.000\n,c,1,1.000\n");
}

TEST(TimingTable, DoesNotReplaceAnotherFile) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "t.csv", "something else\n");
  EXPECT_THROW(TimingTable(folder / "t.csv"), io::Error);
  EXPECT_EQ(read_file(folder / "t.csv"), "something else\n");
}

}  // namespace
}  // namespace groundgrid::program
