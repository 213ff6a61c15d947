#pragma once

#include <stdexcept>
#include <string>

namespace clapotis {

/// Something the user gave cannot be used; the message is a whole sentence. Exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written; the message names it and the reason. Exit code 4.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The state of the simulation stopped being physical. The simulation stands on the last good state. Exit
/// code 5.
struct Diverged : std::runtime_error {
  Diverged(const std::string& sentence, long at_step, double at_time, long of_particle)
      : std::runtime_error(sentence), step(at_step), time(at_time), particle(of_particle) {}
  long step;
  double time;
  long particle;
};

}  // namespace clapotis
