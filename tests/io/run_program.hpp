#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "temporary_folder.hpp"

namespace groundgrid::test {

struct ProgramRun {
  int exit_code;
  std::string output;  ///< What went to standard output.
  std::string words;   ///< What went to standard error.
};

/// A word as the shell must see it.
inline std::string shell_word(const std::filesystem::path& word) {
  std::string quoted = "'";
  return quoted.append(word.string()).append("'");
}

/// Runs the built program with these arguments, written as for the shell. `before` is put before
/// the program's name in the same shell; `output`, where given, is what standard output goes to.
inline ProgramRun run_program(const std::string& arguments, const std::string& before = "",
                              std::filesystem::path output = {}) {
  const TemporaryFolder folder;
  if (output.empty()) output = folder / "out";
  const std::string command = before + shell_word(GROUNDGRID_EXECUTABLE) + " " + arguments + " >" +
                              shell_word(output) + " 2>" + shell_word(folder / "err");
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / "out"),
          read_file(folder / "err")};
}

}  // namespace groundgrid::test
