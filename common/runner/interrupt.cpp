#include "common/runner/interrupt.hpp"

#include <array>
#include <csignal>

namespace clapotis {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

/// A signal handler can reach nothing but this.
volatile std::sig_atomic_t was_asked = 0;

void note(int) { was_asked = 1; }

}  // namespace

Interrupt::Interrupt() {
  was_asked = 0;
  for (const int signal : signals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler == SIG_IGN) continue;
    struct sigaction once {};
    once.sa_handler = note;
    once.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&once.sa_mask);
    sigaction(signal, &once, nullptr);
  }
}

Interrupt::~Interrupt() {
  for (const int signal : signals) {
    struct sigaction present {};
    sigaction(signal, nullptr, &present);
    if (present.sa_handler == note) std::signal(signal, SIG_DFL);
  }
}

bool Interrupt::asked() { return was_asked != 0; }

}  // namespace clapotis
