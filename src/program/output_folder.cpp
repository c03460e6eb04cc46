#include "program/output_folder.hpp"

#include <fmt/format.h>

#include <system_error>

#include "io/error.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw io::Error({.file = folder,
                     .expected = "a folder to write to",
                     .got = error.message(),
                     .remedy = "choose another --output"});
}

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error)
    throw io::Error({.file = path,
                     .expected = "a file that can be replaced",
                     .got = error.message(),
                     .remedy = "move it away or choose another --output"});
}

void require_other_file(const io::ScanFile& scan, const std::filesystem::path& path) {
  std::error_code not_there;
  if (std::filesystem::equivalent(path, scan.path, not_there))
    throw UsageError(
        fmt::format("{}: would be overwritten by its own answer; choose another "
                    "--output",
                    scan.path.string()));
}

}  // namespace groundgrid::program
