#include "io/scan_sequence.hpp"

#include <gtest/gtest.h>

#include "io/error.hpp"
#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

using test::contains;
using test::Names;
namespace fs = std::filesystem;
using test::message_of;
using test::write_file;

std::vector<std::string> names_of(const std::vector<ScanSequence>& sequences) {
  std::vector<std::string> names;
  for (const ScanSequence& sequence : sequences) names.push_back(sequence.name);
  return names;
}

std::vector<std::string> scans_of(const ScanSequence& sequence) {
  std::vector<std::string> names;
  for (const ScanFile& scan : sequence.scans) names.push_back(scan.name);
  return names;
}

class Dataset : public ::testing::Test {
 protected:
  Dataset() {
    for (const char* const scan : {"000010", "000002", "000000"})
      write_file(folder / "sequences/00/velodyne" / (std::string(scan) + ".bin"), "");
    write_file(folder / "sequences/00/velodyne/._000000.bin", "");
    write_file(folder / "sequences/00/velodyne/notes.txt", "");
    write_file(folder / "sequences/08/velodyne/000000.bin", "");
    write_file(folder / "sequences/notes.txt", "");
    write_file(folder / "sequences/empty/notes.txt", "");
  }

  test::TemporaryFolder folder;
};

TEST_F(Dataset, IsFoundFromAnyOfItsFolders) {
  EXPECT_EQ(names_of(find_sequences(folder.path())), (Names{"00", "08"}));
  EXPECT_EQ(names_of(find_sequences(folder / "sequences")), (Names{"00", "08"}));
  EXPECT_EQ(names_of(find_sequences(folder / "sequences/08")), (Names{"08"}));
  EXPECT_EQ(names_of(find_sequences(folder / "sequences/08/")), (Names{"08"}));
}

TEST_F(Dataset, ListsScansByNumber) {
  const ScanSequence sequence = find_sequences(folder.path()).front();
  EXPECT_EQ(scans_of(sequence), (Names{"000000", "000002", "000010"}));
  EXPECT_EQ(sequence.scans[2].number, 10U);
  EXPECT_EQ(sequence.poses(), folder / "sequences/00/poses.txt");
  EXPECT_FALSE(sequence.plain());
}

TEST_F(Dataset, GivesTheSequencesAskedForOnceAndInThatOrder) {
  const std::vector<std::string> wanted{"8", "0", "00"};
  EXPECT_EQ(names_of(find_sequences(folder.path(), wanted)), (Names{"08", "00"}));
}

TEST_F(Dataset, MustHaveTheSequenceAskedFor) {
  const std::vector<std::string> wanted{"05"};
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder.path(), wanted); }),
                       "expected sequence 05, got the sequences 00, 08"));
}

TEST_F(Dataset, MustNumberItsScans) {
  write_file(folder / "sequences/08/velodyne/last.bin", "");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder.path()); }), "last.bin"));
}

TEST_F(Dataset, KeepsTheNamesOfLinkedSequences) {
  fs::create_directory_symlink(folder / "sequences/08", folder / "sequences/11");
  EXPECT_EQ(names_of(find_sequences(folder.path())), (Names{"00", "08", "11"}));
}

TEST(PlainScans, MayBeAFolderOrAFile) {
  const test::TemporaryFolder folder;
  write_file(folder / "b.bin", "");
  write_file(folder / "a.bin", "");
  write_file(folder / "notes.txt", "");
  const auto in_folder = find_sequences(folder.path());
  ASSERT_EQ(in_folder.size(), 1U);
  EXPECT_TRUE(in_folder.front().plain());
  EXPECT_EQ(scans_of(in_folder.front()), (Names{"a", "b"}));
  EXPECT_EQ(scans_of(find_sequences(folder / "b.bin").front()), (Names{"b"}));
}

TEST(PlainScans, HaveNoSequences) {
  const test::TemporaryFolder folder;
  write_file(folder / "a.bin", "");
  const std::vector<std::string> wanted{"00"};
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder.path(), wanted); }),
                       "leave out --sequence"));
}

TEST(PlainScans, MustBeThere) {
  const test::TemporaryFolder folder;
  write_file(folder / "notes.txt", "");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder.path()); }), "got neither"));
  EXPECT_THROW(find_sequences(folder / "notes.txt"), Error);
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "none"); }),
                       "got nothing of that name"));
}

}  // namespace
}  // namespace groundgrid::io
