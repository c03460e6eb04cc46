#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace groundgrid::evaluation {

/// Remembers the labels of many scans by a 64-bit hash each, so that a second run over them can be
/// compared with the first.
class LabelRecord {
 public:
  void add(std::span<const std::uint32_t> labels);

  [[nodiscard]] std::size_t scans() const { return hashes_.size(); }

  /// Whether these are the labels of scan `index`, counted from 0 in the order of add(). Throws
  /// std::out_of_range where there is none.
  [[nodiscard]] bool holds(std::size_t index, std::span<const std::uint32_t> labels) const;

 private:
  std::vector<std::size_t> hashes_;
};

}  // namespace groundgrid::evaluation
