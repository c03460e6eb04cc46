#include "program/input_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include "program/label_file.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {

namespace fs = std::filesystem;

void InputFiles::add(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0)
    known_.emplace(Identity(status.st_dev, status.st_ino), file);
}

void InputFiles::add(const io::ScanSequence& sequence) {
  for (const io::ScanFile& scan : sequence.scans) add(scan.path);
  if (sequence.plain()) return;
  for (const fs::path& file : {sequence.poses(), sequence.calibration(), sequence.times()})
    add(file);
  for (const io::ScanFile& scan : sequence.scans) add(label_file(sequence.labels(), scan));
}

void InputFiles::keep(const fs::path& output) const {
  struct stat status {};
  if (::stat(output.c_str(), &status) != 0) return;
  const auto found = known_.find({status.st_dev, status.st_ino});
  if (found != known_.end())
    throw UsageError(fmt::format("{}: would be overwritten as {}; choose another output",
                                 found->second.string(), output.string()));
}

}  // namespace groundgrid::program
