#include "io/bin_layout_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace groundgrid::io {
namespace {

constexpr std::array<BinLayout, 6> kLayouts{
    {kKittiLayout, kNuscenesLayout, BinLayout{"xyz", FieldType::float32},
     BinLayout{"xyzirt", FieldType::float32}, BinLayout{"xyzi", FieldType::float64},
     BinLayout{"xyz", FieldType::float64}}};

// A whole number of points in each of the layouts, and so many of these from all over the file:
// enough for the statistics, and far less time than reading takes.
constexpr std::size_t kBlockBytes = 480;
constexpr std::size_t kMostBlocks = 64;

// What a coordinate may be besides zero, NaN and infinite. Counters and the halves of doubles are
// next to nothing or beyond the moon as floats. Floats as doubles are so less surely, hence the
// closer bounds; floats in a map's frame are let through, since `info` says what is wrong with
// them.
struct Bounds {
  double least_m, most_m;
};
constexpr Bounds kFloatBounds{1e-30, 1e7};
constexpr Bounds kDoubleBounds{1e-6, 1e3};
// A few coordinates may be anything: noise, a marker of no return.
constexpr double kLeastPlausibleShare = 0.99;

// Real scans have 0.5 bits or more in the right layout; wrong ones that share no column have 0.03
// at most, and those that share some (six floats read as three) two thirds.
constexpr double kLeastInformation = 0.1;
constexpr double kRivalShare = 0.8;

std::vector<std::byte> sample_of(std::span<const std::byte> file) {
  const std::size_t blocks = file.size() / kBlockBytes;
  if (blocks <= kMostBlocks) return {file.begin(), file.end()};
  std::vector<std::byte> sample;
  for (std::size_t i = 0; i < kMostBlocks; ++i) {
    const auto block = file.subspan(i * blocks / kMostBlocks * kBlockBytes, kBlockBytes);
    sample.insert(sample.end(), block.begin(), block.end());
  }
  return sample;
}

template <typename Number>
std::vector<Number> numbers_in(std::span<const std::byte> bytes, const BinLayout& layout) {
  std::vector<Number> numbers(bytes.size() / layout.bytes() * layout.numbers());
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

template <typename Float>
bool are_coordinates(std::span<const Float> numbers, std::size_t columns, const Bounds& bounds) {
  std::size_t plausible = 0;
  for (std::size_t i = 0; i < numbers.size(); i += columns)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = std::abs(static_cast<double>(numbers[i + axis]));
      if (!std::isfinite(size) || size == 0.0 || (size >= bounds.least_m && size <= bounds.most_m))
        ++plausible;
    }
  const std::size_t all = numbers.size() / columns * 3;
  return static_cast<double>(plausible) >= kLeastPlausibleShare * static_cast<double>(all);
}

double sum_of_n_log_n(std::span<const std::uint32_t> counts) {
  double sum = 0.0;
  for (const std::uint32_t n : counts)
    if (n > 1) sum += n * std::log2(static_cast<double>(n));
  return sum;
}

// Bits that the column of a number tells about its size, and what chance adds to them
// (Miller-Madow).
struct Information {
  double bits = 0.0;
  double chance = 0.0;
};

// Sizes are sign, exponent and some bits of the mantissa.
template <typename Word>
Information information_in(std::span<const Word> words, std::size_t columns) {
  constexpr int kMantissaBits = 1;
  constexpr int kSizeBits = (sizeof(Word) == 4 ? 9 : 12) + kMantissaBits;
  constexpr std::size_t kSizes = std::size_t{1} << static_cast<unsigned>(kSizeBits);
  if (words.empty()) return {};
  std::vector<std::uint32_t> all(kSizes);
  std::vector<std::uint32_t> of_column(kSizes * columns);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto size = static_cast<std::size_t>(words[i] >> (8 * sizeof(Word) - kSizeBits));
    ++all[size];
    ++of_column[i % columns * kSizes + size];
  }
  const auto n = static_cast<double>(words.size());
  const auto used = static_cast<double>(
      std::count_if(all.begin(), all.end(), [](std::uint32_t count) { return count > 0; }));
  const auto k = static_cast<double>(columns);
  const double chance = (used - 1.0) * (k - 1.0) / (2.0 * n * std::log(2.0));
  return {std::log2(k) + (sum_of_n_log_n(of_column) - sum_of_n_log_n(all)) / n - chance, chance};
}

struct Fit {
  BinLayout layout;
  Information information;
};

template <typename Float, typename Word>
void add_if_it_fits(std::vector<Fit>& fits, std::span<const std::byte> sample,
                    const BinLayout& layout, const Bounds& bounds) {
  const std::vector<Float> numbers = numbers_in<Float>(sample, layout);
  if (!are_coordinates(std::span(numbers), layout.numbers(), bounds)) return;
  const std::vector<Word> words = numbers_in<Word>(sample, layout);
  fits.push_back({layout, information_in(std::span(words), layout.numbers())});
}

std::vector<Fit> fits_of(std::span<const std::byte> file) {
  const std::vector<std::byte> sample = sample_of(file);
  std::vector<Fit> fits;
  for (const BinLayout& layout : kLayouts) {
    if (file.size() % layout.bytes() != 0) continue;
    if (layout.number() == FieldType::float32)
      add_if_it_fits<float, std::uint32_t>(fits, sample, layout, kFloatBounds);
    else
      add_if_it_fits<double, std::uint64_t>(fits, sample, layout, kDoubleBounds);
  }
  return fits;
}

// Two points of three numbers are one of six just as well.
bool repeats(const BinLayout& longer, const BinLayout& shorter) {
  return longer.number() == shorter.number() && longer.numbers() > shorter.numbers() &&
         longer.numbers() % shorter.numbers() == 0;
}

}  // namespace

std::vector<BinLayout> likely_layouts(std::span<const std::byte> file, const BinLayout& usual) {
  const std::vector<Fit> fits = fits_of(file);
  double best = 0.0;
  for (const Fit& fit : fits)
    if (fit.information.bits > kLeastInformation + fit.information.chance)
      best = std::max(best, fit.information.bits);
  std::vector<BinLayout> likely;
  for (const Fit& fit : fits) {
    if (best == 0.0 && fit.layout == usual) return {usual};
    if (best == 0.0 || fit.information.bits >= kRivalShare * best) likely.push_back(fit.layout);
  }
  const std::vector<BinLayout> rivals = likely;
  std::erase_if(likely, [&](const BinLayout& layout) {
    return std::any_of(rivals.begin(), rivals.end(),
                       [&](const BinLayout& rival) { return repeats(layout, rival); });
  });
  return likely;
}

}  // namespace groundgrid::io
