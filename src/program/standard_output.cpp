#include "program/standard_output.hpp"

#include <cerrno>
#include <cstdio>

#include "io/error.hpp"

namespace groundgrid::program {

void print_result(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    throw io::Error({.file = "standard output",
                     .expected = "a place to write to",
                     .got = io::system_message(errno)});
}

}  // namespace groundgrid::program
