#include "rendering/nice_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace groundgrid::rendering {
namespace {

// For quotients that should be whole numbers.
constexpr double kRounding = 1e-9;

}  // namespace

double nice_below(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit) + kRounding));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= limit * (1.0 + kRounding)) return factor * power;
  return power;
}

double nice_above(double limit) {
  const double below = nice_below(limit);
  if (below >= limit * (1.0 - kRounding)) return below;
  for (const double factor : {2.0, 2.5})
    if (const double nice = nice_below(below * factor); nice > below) return nice;
  return below;
}

std::vector<double> ticks_between(double low, double high, int most) {
  const double step = nice_above((high - low) / std::max(most - 1, 1));
  std::vector<double> ticks;
  const auto last = static_cast<long>(std::floor(high / step + kRounding));
  for (auto i = static_cast<long>(std::ceil(low / step - kRounding)); i <= last; ++i)
    ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::string tick_text(double tick, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + kRounding)));
  return fmt::format("{}{:.{}f}", tick < 0.0 ? "\u2212" : "", std::abs(tick), decimals);
}

}  // namespace groundgrid::rendering
