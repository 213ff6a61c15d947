#pragma once

#include <algorithm>

namespace clapotis {

/// Keeps simulated time apart from the frame rate. Real time that passes makes the window owe simulated time;
/// steps pay it back. A frame that was late owes no more than a tenth of a second, and what cannot be paid
/// within a frame's bound of work is forgiven: after a stall nothing is caught up.
class Pacer {
 public:
  static constexpr double longest_frame = 0.1;  ///< [s]

  /// `elapsed` seconds have passed; the user asked for `speed` simulated seconds per second.
  void pass(double elapsed, double speed) { owed_ += std::clamp(elapsed, 0.0, longest_frame) * speed; }
  /// Whether a step of dt is due. A step longer than a frame comes due after several frames.
  [[nodiscard]] bool due(double dt) const { return owed_ >= dt; }
  void pay(double dt) { owed_ -= dt; }
  void forgive() { owed_ = 0; }

 private:
  double owed_ = 0;  ///< simulated time [s]
};

}  // namespace clapotis
