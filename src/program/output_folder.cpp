#include "program/output_folder.hpp"

#include <system_error>

#include "io/error.hpp"

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

}  // namespace groundgrid::program
