#pragma once

#include <cstdio>
#include <cstdlib>

namespace groundgrid::fuzz {

/// Ends the program where what must hold does not: a finding.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

}  // namespace groundgrid::fuzz
