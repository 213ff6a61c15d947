#pragma once

namespace clapotis {

/// Height above the floor y [m] and upward speed v [m/s] of a ball.
struct BallState {
  double y;
  double v;
};

/// Free fall in air: y'' = -g - y'/tau, with the drag time tau = m/beta of the force -beta v. With s = t/tau,
///   v = v0 phi0(s) - g t phi1(s),   y = y0 + v0 t phi1(s) - g t^2 phi2(s),
///   phi0 = exp(-s), phi1 = (1 - phi0)/s, phi2 = (1 - phi1)/s,
/// which tends to the parabola as tau grows (phi1 = 1, phi2 = 1/2 at s = 0) without losing a digit.
/// Any consistent units (m, s or px, s). Handout, section III.
struct Fall {
  double height;     ///< y0 [m], any sign for `at`, >= 0 for `landing_time`
  double speed;      ///< v0 [m/s], upward
  double gravity;    ///< g [m/s^2], >= 0, downward
  double drag_time;  ///< tau [s], > 0; infinity: no drag

  BallState at(double t) const;

  /// First time [s] at which the ball comes down to y = 0; the start of a flight from the floor does not
  /// count. Zero for a ball that starts on the floor and goes down or is at rest under gravity; infinity if
  /// it never comes down (no gravity and no, or too little, downward speed).
  double landing_time() const;
};

}  // namespace clapotis
