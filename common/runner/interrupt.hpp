#pragma once

namespace clapotis {

/// While it lives, Ctrl-C, a kill and a closed terminal ask the run to end instead of ending the program, so
/// that what was computed is kept. Asked a second time, the program ends at once. A signal that was ignored
/// stays so.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] static bool asked();
};

}  // namespace clapotis
