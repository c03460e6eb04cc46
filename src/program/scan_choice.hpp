#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "io/scan_sequence.hpp"
#include "program/input_options.hpp"

namespace groundgrid::program {

/// "sequence 00, scan 000040", after "simulated" where it is, or the scan alone outside of a
/// dataset.
std::string words_of(const io::ScanSequence& sequence, const io::ScanFile& scan);

/// One scan and the sequence that it belongs to.
struct ChosenScan {
  io::ScanSequence sequence{};
  std::size_t index = 0;

  [[nodiscard]] const io::ScanFile& scan() const { return sequence.scans[index]; }
  [[nodiscard]] std::string words() const { return words_of(sequence, scan()); }
};

/// The only sequence of the input. Throws UsageError where there are several, and as
/// InputOptions::find_sequences() does.
io::ScanSequence only_sequence(const InputOptions& input);

/// The scan with that number of the only sequence, or its only scan. Throws UsageError where there
/// are several and no number, io::Error where none has it.
ChosenScan choose_scan(const InputOptions& input, std::optional<std::size_t> number);

}  // namespace groundgrid::program
