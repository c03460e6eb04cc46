#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>

namespace groundgrid::fuzz {

/// Reads values from a fuzzer's bytes; zeros once they are used up.
class InputBytes {
 public:
  explicit InputBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool empty() const { return bytes_.empty(); }

  template <typename Value>
  Value take() {
    Value value{};
    const std::size_t size = std::min(sizeof(Value), bytes_.size());
    std::memcpy(&value, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return value;
  }

  /// 0 to `bound` - 1.
  unsigned below(unsigned bound) { return take<std::uint8_t>() % bound; }

  /// A number that a scan or a pose may hold, or must not: mostly near zero, sometimes of any size,
  /// sometimes none at all.
  double number() {
    const auto kind = take<std::uint8_t>();
    if (kind < 160) return take<std::int8_t>() * 0.125;
    if (kind < 224) return take<std::int16_t>() * 0.01;
    if (kind < 240) return static_cast<double>(take<float>());
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr std::array kSpecial{0.0,   -0.0,  1e-30, 60.0, -60.0, 1e5,  -1e6,      1e9,
                                  1.5e9, -1e30, 1e300, kNan, kNan,  kNan, kInfinity, -kInfinity};
    return kSpecial[kind - 240];
  }

  /// The next `size` bytes, or what is left of them, as text.
  std::string text(std::size_t size) {
    const auto taken = bytes_.first(std::min(size, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return {taken.begin(), taken.end()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace groundgrid::fuzz
