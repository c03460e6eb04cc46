#include "io/path_checks.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"

namespace groundgrid::io {
namespace {

namespace fs = std::filesystem;

class PathChecks : public ::testing::Test {
 protected:
  PathChecks() {
    test::write_file(folder / "file", "");
    fs::create_directory(folder / "folder");
    fs::create_symlink("folder", folder / "link");
    fs::create_symlink("nowhere", folder / "dangling");
    fs::create_symlink("loop", folder / "loop");
  }

  test::TemporaryFolder folder;
};

TEST_F(PathChecks, FindWhatHasTheName) {
  for (const char* const name : {"file", "folder", "link", "."})
    EXPECT_TRUE(is_there(folder / name)) << name;
}

TEST_F(PathChecks, FindWhatOnlyOpeningCanTell) {
  // A name of more than 255 letters is an error other than "not found".
  for (const std::string& name : {std::string("dangling"), std::string("loop"),
                                  std::string("loop/file"), std::string(300, 'x')})
    EXPECT_TRUE(is_there(folder / name)) << name;
}

TEST_F(PathChecks, FindNothingWhereThereIsNothing) {
  for (const char* const name : {"none", "none/file", "file/below", "folder/none"})
    EXPECT_FALSE(is_there(folder / name)) << name;
  EXPECT_FALSE(is_there(""));
}

TEST_F(PathChecks, TellFoldersFromOtherThings) {
  for (const char* const name : {"folder", "link", "."})
    EXPECT_TRUE(is_folder(folder / name)) << name;
  for (const char* const name : {"file", "dangling", "loop", "loop/below", "none"})
    EXPECT_FALSE(is_folder(folder / name)) << name;
}

}  // namespace
}  // namespace groundgrid::io
