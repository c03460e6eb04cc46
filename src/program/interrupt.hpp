#pragma once

namespace groundgrid::program {

/// From here on SIGINT and SIGTERM no longer end the process at once: check_interrupt() does it in
/// good order, between two scans. Nor does SIGPIPE: writing to a closed pipe fails as any write
/// may.
void catch_interrupts();

/// Throws std::runtime_error once one of the two has come, so that files being written are removed.
void check_interrupt();

}  // namespace groundgrid::program
