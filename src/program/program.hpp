#pragma once

namespace groundgrid::program {

/// The exit codes scripts can rely on.
inline constexpr int kDone = 0;
inline constexpr int kBadInput = 1;  ///< Bad input, failed reading or writing, interrupted.
inline constexpr int kBadUsage = 2;  ///< Unknown flags, values out of range.

/// The program: reads the command line, runs the sub-command, says on standard error what went
/// wrong, and returns the exit code.
int run(int argc, const char* const* argv);

}  // namespace groundgrid::program
