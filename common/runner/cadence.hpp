#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace clapotis {

/// When something that is done every `interval` of simulated time is due: at the first step at or after each
/// multiple. It only watches the clock, so that output never alters a trajectory.
class Cadence {
 public:
  /// An interval of 0 is due at every step [s].
  explicit Cadence(double interval) : interval_(interval) {}

  /// Whether the state at `time` is at or after the next multiple; `dt` is the step that goes on from it.
  [[nodiscard]] bool due(double time, double dt) const {
    return interval_ <= 0 || time + rounding * dt >= next();
  }
  /// What was due at `time` is done.
  void serve(double time, double dt) {
    if (interval_ > 0) served_ = std::floor((time + rounding * dt) / interval_);
  }

  /// The next multiple [s].
  [[nodiscard]] double next() const { return (served_ + 1) * interval_; }

 private:
  /// A sum of many steps misses a multiple of the interval by rounding; this share of a step forgives it.
  static constexpr double rounding = 1e-6;
  double interval_, served_ = 0;
};

/// How often a run of this length [s] is noted when nobody says: each step of a short one (0), some hundred
/// times in a long one. A row of many particles costs as much as two steps, so that ten steps lie between.
inline double usual_interval(double dt, double length, std::ptrdiff_t particles) {
  constexpr double steps_of_a_short_run = 1000, rows_of_a_long_run = 500, steps_between = 10;
  constexpr std::ptrdiff_t many = 1000;
  if (particles > many) return std::max(steps_between * dt, length / rows_of_a_long_run);
  return length <= steps_of_a_short_run * dt ? 0 : length / rows_of_a_long_run;
}

}  // namespace clapotis
