#include "evaluation/label_record.hpp"

#include <functional>
#include <string_view>

namespace groundgrid::evaluation {
namespace {

std::size_t hash_of(std::span<const std::uint32_t> labels) {
  const auto bytes = std::as_bytes(labels);
  return std::hash<std::string_view>{}({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

void LabelRecord::add(std::span<const std::uint32_t> labels) { hashes_.push_back(hash_of(labels)); }

bool LabelRecord::holds(std::size_t index, std::span<const std::uint32_t> labels) const {
  return hashes_.at(index) == hash_of(labels);
}

}  // namespace groundgrid::evaluation
