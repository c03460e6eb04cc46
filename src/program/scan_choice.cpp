#include "program/scan_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {

std::string words_of(const io::ScanSequence& sequence, const io::ScanFile& scan) {
  if (sequence.plain()) return fmt::format("scan {}", scan.name);
  // What `simulate` leaves. No picture of a simulated drive may pass for one of a real one.
  const bool simulated = io::is_there(sequence.folder / "truth" / "drive.json");
  return fmt::format("{}sequence {}, scan {}", simulated ? "simulated " : "", sequence.name,
                     scan.name);
}

io::ScanSequence only_sequence(const InputOptions& input) {
  std::vector<io::ScanSequence> sequences = input.find_sequences();
  if (sequences.size() > 1)
    throw UsageError(fmt::format("{} holds {} sequences; choose one with --sequence",
                                 input.path().string(), sequences.size()));
  return std::move(sequences.front());
}

ChosenScan choose_scan(const InputOptions& input, std::optional<std::size_t> number) {
  ChosenScan chosen{.sequence = only_sequence(input)};
  const std::vector<io::ScanFile>& scans = chosen.sequence.scans;
  if (!number) {
    if (scans.size() == 1) return chosen;
    throw UsageError(fmt::format("{} holds {} scans; choose one with --scan",
                                 chosen.sequence.folder.string(), scans.size()));
  }
  const auto found = std::find_if(scans.begin(), scans.end(),
                                  [&](const io::ScanFile& scan) { return scan.number == *number; });
  if (found == scans.end())
    throw io::Error({.file = chosen.sequence.folder,
                     .expected = fmt::format("a scan with the number {}", *number),
                     .got = fmt::format("{} scans, numbers {} to {}", scans.size(),
                                        scans.front().number, scans.back().number)});
  chosen.index = static_cast<std::size_t>(found - scans.begin());
  return chosen;
}

}  // namespace groundgrid::program
