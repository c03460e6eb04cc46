#pragma once

namespace groundgrid::program {

/// From here on SIGINT, SIGTERM and SIGHUP no longer end the process at once: check_interrupt()
/// does it in good order, between two scans. Nor do SIGPIPE and SIGXFSZ: writing to a closed pipe
/// or beyond the limit of file sizes fails as any write may.
void catch_interrupts();

/// Throws std::runtime_error once one of the three has come, so that files being written are
/// removed.
void check_interrupt();

}  // namespace groundgrid::program
