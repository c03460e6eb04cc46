#include "io/scan_sequence.hpp"

#include <gtest/gtest.h>

#include <array>

#include "cloud_checks.hpp"
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

TEST_F(Dataset, TakesScansOfEveryFormat) {
  for (const char* const scan : {"3.pcd", "000001.ply", "12.pcd.bin"})
    write_file(folder / "sequences/09/velodyne" / scan, "");
  const ScanSequence sequence = find_sequences(folder / "sequences/09").front();
  EXPECT_EQ(scans_of(sequence), (Names{"000001", "3", "12"}));
  EXPECT_EQ(sequence.scans[0].format, ScanFormat::ply);
  EXPECT_EQ(sequence.scans[1].format, ScanFormat::pcd);
  EXPECT_EQ(sequence.scans[2].format, ScanFormat::nuscenes);
  EXPECT_EQ(sequence.scans[2].number, 12U);
  EXPECT_EQ(sequence.scans[2].index, 2U);
  EXPECT_EQ(sequence.times(), folder / "sequences/09/times.txt");
}

TEST_F(Dataset, TakesTheFormatAskedForWhateverTheEnding) {
  const auto sequences = find_sequences(folder.path(), {}, ScanFormat::nuscenes);
  ASSERT_EQ(sequences.front().scans.size(), 3U);
  for (const ScanFile& scan : sequences.front().scans)
    EXPECT_EQ(scan.format, ScanFormat::nuscenes) << scan.name;
}

TEST_F(Dataset, HasOneScanOfEachNumber) {
  write_file(folder / "sequences/08/velodyne/0.bin", "");
  const std::string message = message_of<Error>([&] { find_sequences(folder.path()); });
  EXPECT_TRUE(contains(message, "expected one scan of each number, got number 0 again"));
  EXPECT_TRUE(contains(message, "velodyne/0.bin"));
  EXPECT_TRUE(contains(message, "velodyne/000000.bin"));
}

TEST_F(Dataset, SaysSoWhereANumberIsTooLarge) {
  write_file(folder / "sequences/08/velodyne/99999999999999999999.bin", "");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder.path()); }),
                       "expected a scan's number as its name (000042.bin), got "
                       "'99999999999999999999'"));
}

TEST_F(Dataset, LeavesScansThatAreNoFilesToReading) {
  fs::create_directory(folder / "sequences/08/velodyne/000004.bin");
  fs::create_symlink("gone", folder / "sequences/08/velodyne/000003.bin");
  const ScanSequence sequence = find_sequences(folder / "sequences/08").front();
  EXPECT_EQ(scans_of(sequence), (Names{"000000", "000003", "000004"}));
}

TEST_F(Dataset, LeavesOutNoSequenceThatCannotBeRead) {
  fs::create_directory(folder / "sequences/09");
  fs::create_symlink(folder / "sequences/09/velodyne", folder / "sequences/09/velodyne");
  const std::string message = message_of<Error>([&] { find_sequences(folder.path()); });
  EXPECT_TRUE(contains(message, "sequences/09/velodyne: expected a readable folder"));
  EXPECT_TRUE(contains(message, "Too many levels of symbolic links"));
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
  EXPECT_TRUE(
      contains(message_of<Error>([&] { find_sequences(folder / "notes.txt"); }), "no path"));
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "none"); }),
                       "got nothing of that name"));
}

TEST(PlainScans, MayBeOfSeveralFormats) {
  const test::TemporaryFolder folder;
  for (const char* const scan : {"a.ply", "b.pcd", "c.pcd.bin", "d.bin", ".hidden.pcd"})
    write_file(folder / scan, "");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  EXPECT_EQ(scans_of(sequence), (Names{"a", "b", "c", "d"}));
  EXPECT_EQ(sequence.scans[0].format, ScanFormat::ply);
  EXPECT_EQ(sequence.scans[1].format, ScanFormat::pcd);
  EXPECT_EQ(sequence.scans[2].format, ScanFormat::nuscenes);
  EXPECT_EQ(sequence.scans[3].format, ScanFormat::kitti);
}

TEST(PlainScans, HaveTheirPlaceAsNumberWhereNotEveryNameIsOne) {
  const test::TemporaryFolder folder;
  for (const char* const scan : {"7.bin", "9.bin", "last.bin"}) write_file(folder / scan, "");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(sequence.scans[i].number, i);
    EXPECT_EQ(sequence.scans[i].index, i);
  }
}

TEST(PlainScans, AreInTheOrderOfTheirNumbersWhereEveryNameIsOne) {
  const test::TemporaryFolder folder;
  for (const char* const scan : {"10.bin", "9.pcd", "1532402927647951.pcd.bin"})
    write_file(folder / scan, "");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  EXPECT_EQ(scans_of(sequence), (Names{"9", "10", "1532402927647951"}));
  EXPECT_EQ(sequence.scans[2].number, 1532402927647951U);
  EXPECT_EQ(sequence.scans[2].index, 2U);
}

TEST(PlainScans, MayHaveNamesThatNoNumberHolds) {
  const test::TemporaryFolder folder;
  write_file(folder / "99999999999999999999999.bin", "");
  write_file(folder / "-1.bin", "");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  EXPECT_EQ(scans_of(sequence), (Names{"-1", "99999999999999999999999"}));
  EXPECT_EQ(sequence.scans[1].number, 1U);
}

TEST(PlainScans, MustHaveDifferentNames) {
  const test::TemporaryFolder folder;
  write_file(folder / "a.pcd", "");
  write_file(folder / "a.ply", "");
  const std::string message = message_of<Error>([&] { find_sequences(folder.path()); });
  EXPECT_TRUE(contains(message, "a.pcd"));
  EXPECT_TRUE(contains(message, "a.ply"));
  EXPECT_TRUE(contains(message, "the name 'a' again"));
}

TEST(PlainScans, ThatAreNoFilesAreLeftToReading) {
  const test::TemporaryFolder folder;
  write_file(folder / "a.bin", "");
  fs::create_directory(folder / "b.bin");
  fs::create_symlink("gone", folder / "c.bin");
  fs::create_symlink("d.bin", folder / "d.bin");
  const ScanSequence sequence = find_sequences(folder.path()).front();
  ASSERT_EQ(scans_of(sequence), (Names{"a", "b", "c", "d"}));
  const std::array reasons{"b.bin: expected a file, got a directory",
                           "c.bin: expected a file, got nothing of that name",
                           "d.bin: expected a regular file, got Too many levels of symbolic links"};
  for (std::size_t i = 0; i < reasons.size(); ++i)
    EXPECT_TRUE(
        contains(test::error_of(sequence.scans[i + 1].path, ScanFormat::kitti), reasons[i]));
}

TEST(PlainScans, MustBeFilesWhereTheyAreTheInputItself) {
  const test::TemporaryFolder folder;
  fs::create_symlink("gone", folder / "a.bin");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "a.bin"); }),
                       "got nothing of that name; check the path"));
  fs::create_symlink("b.bin", folder / "b.bin");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "b.bin"); }),
                       "got Too many levels of symbolic links; check the path"));
}

/// Takes the process to a folder that is then removed, and back at the end.
class GoneWorkingFolder {
 public:
  GoneWorkingFolder() {
    const test::TemporaryFolder folder;
    fs::current_path(folder.path());
  }
  ~GoneWorkingFolder() { fs::current_path(before_); }
  GoneWorkingFolder(const GoneWorkingFolder&) = delete;
  GoneWorkingFolder& operator=(const GoneWorkingFolder&) = delete;

 private:
  fs::path before_ = fs::current_path();
};

TEST(PlainScans, AreNotSoughtInAFolderThatIsGone) {
  const GoneWorkingFolder gone;
  EXPECT_TRUE(contains(message_of<Error>([] { find_sequences("."); }),
                       ".: expected a readable folder, got No such file"));
}

TEST(PlainScans, MayHaveAnyEndingWhereTheFormatIsSaid) {
  const test::TemporaryFolder folder;
  write_file(folder / "scan.dat", "");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "scan.dat"); }),
                       "if it is a scan, say of which kind with --format"));
  const ScanSequence sequence = find_sequences(folder / "scan.dat", {}, ScanFormat::pcd).front();
  EXPECT_EQ(scans_of(sequence), (Names{"scan"}));
  EXPECT_EQ(sequence.scans[0].format, ScanFormat::pcd);
}

TEST(ScanLists, GiveScansInTheirOwnOrder) {
  const test::TemporaryFolder folder;
  for (const char* const scan : {"far/7.bin", "3.pcd", "5.ply"}) write_file(folder / scan, "");
  write_file(folder / "scans.txt",
             "# first the far one\n\n  far/7.bin\r\n" + (folder / "5.ply").string() + "\n3.pcd");
  const ScanSequence sequence = find_sequences(folder / "scans.txt").front();
  EXPECT_TRUE(sequence.plain());
  EXPECT_EQ(sequence.folder, folder.path());
  EXPECT_EQ(scans_of(sequence), (Names{"7", "5", "3"}));
  EXPECT_EQ(sequence.scans[0].path, folder / "far/7.bin");
  EXPECT_EQ(sequence.scans[1].format, ScanFormat::ply);
  EXPECT_EQ(sequence.scans[1].number, 5U);
  EXPECT_EQ(sequence.scans[2].index, 2U);
}

TEST(ScanLists, AreToldByTheirEndingInAnyCase) {
  const test::TemporaryFolder folder;
  write_file(folder / "A.BIN", "");
  for (const char* const list : {"scans.TXT", "scans.Lst"}) {
    write_file(folder / list, "A.BIN\n");
    EXPECT_EQ(scans_of(find_sequences(folder / list).front()), (Names{"A"})) << list;
  }
}

TEST(ScanLists, MayBeginWithAByteOrderMark) {
  const test::TemporaryFolder folder;
  write_file(folder / "a.bin", "");
  write_file(folder / "scans.txt",
             "\xEF\xBB\xBF"
             "a.bin\n");
  EXPECT_EQ(scans_of(find_sequences(folder / "scans.txt").front()), (Names{"a"}));
  write_file(folder / "comment.txt", "\xEF\xBB\xBF# one\na.bin\n");
  EXPECT_EQ(scans_of(find_sequences(folder / "comment.txt").front()), (Names{"a"}));
}

TEST(ScanLists, NameThemselvesTheLineAndTheMissingFile) {
  const test::TemporaryFolder folder;
  write_file(folder / "a.bin", "");
  write_file(folder / "scans.lst", "a.bin\n\nb.bin\n");
  const std::string message = message_of<Error>([&] { find_sequences(folder / "scans.lst"); });
  EXPECT_TRUE(contains(message, "scans.lst, line 3"));
  EXPECT_TRUE(contains(message, (folder / "b.bin").string() +
                                    ", which is nothing of that name; a .txt or .lst file "
                                    "is a list of scans; give a scan another ending"));
}

TEST(ScanLists, AreNoScansWhateverTheFormat) {
  const test::TemporaryFolder folder;
  write_file(folder / "scan.txt", "VERSION 0.7\n");
  const std::string remedy = "a .txt or .lst file is a list of scans; give a scan another ending";
  const auto message = [&](const char* file) {
    return message_of<Error>([&] { find_sequences(folder / file, {}, ScanFormat::pcd); });
  };
  EXPECT_TRUE(contains(message("scan.txt"), "scan.txt, line 1: expected the path of a scan"));
  EXPECT_TRUE(contains(message("scan.txt"), remedy));
  write_file(folder / "empty.txt", "");
  EXPECT_TRUE(contains(message("empty.txt"), remedy));
  write_file(folder / "cloud.txt", "1 2 3\n");
  EXPECT_EQ(find_sequences(folder / "cloud.txt", {}, ScanFormat::pcd).front().scans[0].format,
            ScanFormat::pcd);
}

TEST(ScanLists, HoldScansOnly) {
  const test::TemporaryFolder folder;
  write_file(folder / "notes.dat", "");
  write_file(folder / "scans.txt", "notes.dat\n");
  const std::string message = message_of<Error>([&] { find_sequences(folder / "scans.txt"); });
  EXPECT_TRUE(contains(message, "scans.txt, line 1: expected a scan"));
  EXPECT_TRUE(contains(message, "--format"));
  EXPECT_EQ(find_sequences(folder / "scans.txt", {}, ScanFormat::kitti).front().scans[0].format,
            ScanFormat::kitti);
}

TEST(ScanLists, HoldOneScanOfEachName) {
  const test::TemporaryFolder folder;
  write_file(folder / "one/a.bin", "");
  write_file(folder / "two/a.bin", "");
  write_file(folder / "scans.txt", "one/a.bin\ntwo/a.bin\n");
  const std::string message = message_of<Error>([&] { find_sequences(folder / "scans.txt"); });
  EXPECT_TRUE(contains(message, "one/a.bin"));
  EXPECT_TRUE(contains(message, "two/a.bin"));
}

TEST(ScanLists, HoldSomething) {
  const test::TemporaryFolder folder;
  write_file(folder / "scans.txt", "# none\n");
  EXPECT_TRUE(contains(message_of<Error>([&] { find_sequences(folder / "scans.txt"); }),
                       "expected the path of one scan a line, got no path"));
}

}  // namespace
}  // namespace groundgrid::io
