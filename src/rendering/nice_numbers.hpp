#pragma once

#include <string>
#include <vector>

namespace groundgrid::rendering {

/// The greatest of 1, 2 and 5 times a power of ten that is at most `limit`, which is positive.
double nice_below(double limit);

/// The least of them that is at least `limit`.
double nice_above(double limit);

/// The multiples from `low` to `high` of the least nice number that gives at most `most` of them.
std::vector<double> ticks_between(double low, double high, int most);

/// A multiple of a nice step in words: with as many decimals as the step needs, and a
/// true minus sign.
std::string tick_text(double tick, double step);

}  // namespace groundgrid::rendering
