#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace groundgrid::simulation {

/// A random number is a hash of what it is for: the seed, then scan, ray, purpose and the like. No
/// state is shared, so the order of the work and the number of threads change nothing.
constexpr std::uint64_t hash(std::initializer_list<std::uint64_t> words) {
  std::uint64_t state = 0x243F6A8885A308D3U;
  for (const std::uint64_t word : words) {
    state += word + 0x9E3779B97F4A7C15U;
    state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
    state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
    state ^= state >> 31U;
  }
  return state;
}

/// Numbers one after another from one hash, for a single owner: an object that is placed, a ray.
/// Two of them in the arguments of one call come in no certain order, and so does a copy.
class Random {
 public:
  explicit constexpr Random(std::uint64_t key) : key_(key) {}

  /// In [0, 1).
  constexpr double uniform() {
    return static_cast<double>(hash({key_, ++count_}) >> 11U) * 0x1p-53;
  }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  constexpr bool chance(double probability) { return uniform() < probability; }

  /// With mean 1.
  double exponential() { return -std::log1p(-uniform()); }

  /// With standard deviation 1.
  double normal() {
    const double radius = std::sqrt(2.0 * exponential());
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace groundgrid::simulation
