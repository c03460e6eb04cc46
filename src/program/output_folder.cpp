#include "program/output_folder.hpp"

#include <spdlog/spdlog.h>

#include <system_error>

#include "io/error.hpp"
#include "io/path_checks.hpp"

namespace groundgrid::program {
namespace {

namespace fs = std::filesystem;

void clear_leftovers(const fs::path& folder) {
  if (const std::size_t removed = io::remove_leftovers(folder); removed > 0)
    spdlog::info("{}: removed {} unfinished file{} of runs that were killed", folder.string(),
                 removed, removed == 1 ? "" : "s");
}

const fs::path& made(const fs::path& folder) {
  io::make_folder(folder);
  return folder;
}

}  // namespace

void make_folder(const fs::path& folder) { clear_leftovers(made(folder)); }

OutputFolder::OutputFolder(const fs::path& folder) : lock_(made(folder)) {
  clear_leftovers(folder);
}

void remove_file(const fs::path& path) {
  std::error_code error;
  const bool removed = fs::remove(path, error);
  if (error)
    throw io::Error({.file = path,
                     .expected = "a file that can be replaced",
                     .got = error.message(),
                     .remedy = "move it away or choose another --output"});
  // It must not be back after a power failure, beside files that are newer.
  if (removed) io::sync_folder(io::folder_of(path));
}

}  // namespace groundgrid::program
