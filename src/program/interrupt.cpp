#include "program/interrupt.hpp"

#include <csignal>
#include <stdexcept>

namespace groundgrid::program {
namespace {

// A signal handler may touch nothing else.
volatile std::sig_atomic_t interrupted = 0;  // NOLINT(*-avoid-non-const-global-variables)

void note_interrupt(int /*signal*/) { interrupted = 1; }

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  // A terminal that closes, unless nohup said that it does not matter.
  if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  // Without this a reader that went away ends the process before the failed write is reported.
  std::signal(SIGPIPE, SIG_IGN);
  // The same for a file that grows beyond what the user may write.
  std::signal(SIGXFSZ, SIG_IGN);
}

void check_interrupt() {
  if (interrupted != 0) throw std::runtime_error("interrupted; finished files are kept");
}

}  // namespace groundgrid::program
