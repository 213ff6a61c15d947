#pragma once

#include "common/references/fall.hpp"

namespace clapotis {

/// The n-th meeting of the ball with the floor: when [s], and the upward speed before and after [m/s].
struct Impact {
  double time;
  double v_before;  ///< <= 0
  double v_after;   ///< -e v_before
};

/// The exact bouncing ball: y'' = -g - y'/tau above the floor y = 0, and v+ = -e v- on it.
/// Flights and landing times are those of `Fall`. Handout, section III.
///
/// Round-off is the only error, but for one case: with drag, impacts beyond the 5,000th follow a closed form
/// for small bounces, whose times are right to 1e-8 tau whatever the start. So `at` costs at most about a
/// millisecond. Flights shorter than the round-off of the clock are rest, also for e = 1.
///
/// A ball without gravity meets the floor at most once; a ball that starts at rest on the floor never does.
/// All functions throw std::invalid_argument if a parameter is out of the range given here, or not finite.
struct BouncingBall {
  double height;       ///< y at t = 0 [m], >= 0
  double speed;        ///< v at t = 0 [m/s], upward
  double gravity;      ///< g [m/s^2], >= 0, downward
  double drag_time;    ///< tau = m/beta [s], > 0; infinity: no drag
  double restitution;  ///< e, no unit, 0 to 1

  /// State at t [s] >= 0. At the time of an impact, the state after it; y = 0 and v = 0 once at rest.
  BallState at(double t) const;

  /// n-th impact, n >= 1; {infinity, 0, 0} if there are fewer.
  Impact impact(int n) const;

  /// When the impacts have accumulated and the ball lies still [s]; infinity for e = 1.
  double rest_time() const;
};

}  // namespace clapotis
