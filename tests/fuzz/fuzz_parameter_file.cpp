// Any text as a parameter file: it is read, or refused with a message of one line.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "groundgrid/parameters.hpp"
#include "io/error.hpp"
#include "program/parameter_file.hpp"
#include "program/usage_error.hpp"
#include "require.hpp"

namespace groundgrid::fuzz {
namespace {

// A file of this process; gone at its end.
class ScratchFile {
 public:
  ScratchFile() = default;
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() { std::filesystem::remove(path_); }

  const std::string& with(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_;
  }

 private:
  std::string path_ = std::filesystem::temp_directory_path() /
                      ("groundgrid_fuzz_" + std::to_string(getpid()) + ".toml");
};

void run(const std::string& path) {
  Config config;
  try {
    for (const program::FileParameter& given : program::read_parameter_file(path)) {
      require(given.place.starts_with(path + ", line "), "a parameter has its place");
      try {
        set_parameter(config, given.name, given.value);
      } catch (const std::invalid_argument&) {
        // No such parameter, or out of its range.
      }
    }
  } catch (const program::UsageError& error) {
    const std::string message = error.what();
    require(message.starts_with(path + ", line "), "a message begins with the place");
    require(message.find('\n') == std::string::npos, "a message is one line");
    require(message.size() < path.size() + 400, "a message is short");
  } catch (const io::Error&) {
    // Too long to be one.
  }
  config.validate();
}

}  // namespace
}  // namespace groundgrid::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const groundgrid::fuzz::ScratchFile file;
  groundgrid::fuzz::run(file.with(data, size));
  return 0;
}
