#pragma once

#include "common/references/bounce.hpp"
#include "stage1_bouncing/scenes.hpp"
#include "tests/common/runs.hpp"

/// The scene `drop` and its published case: from 1 m at rest, g = 9.81 m/s^2, e = 0.8.
namespace clapotis::tests {

inline const Scene& drop() {
  static const Stage stage = stage1::stage();
  return stage.scene("drop");
}
inline const Scene& bounce() {
  static const Stage stage = stage1::stage();
  return stage.scene("bounce");
}

inline constexpr double g = 9.81;
inline constexpr double no_drag = std::numeric_limits<double>::infinity();

/// The exact motion; the drag time m/beta is 1 s in `drop`.
inline BouncingBall exact_ball(double drag_time = 1, double restitution = 0.8) {
  return {.height = 1, .speed = 0, .gravity = g, .drag_time = drag_time, .restitution = restitution};
}

/// How far a run of `drop` is from `exact` at its end.
struct Miss {
  double y, v;
  [[nodiscard]] double either() const { return std::max(y, v); }
};

inline Miss miss(const Scheme& scheme, const Values& values, const BouncingBall& exact, double until,
                 long steps) {
  Simulation simulation(drop(), typed(values, until, steps), scheme.name);
  run_to(simulation, until);
  const auto there = exact.at(until);
  return {std::abs(position(simulation).y - there.y), std::abs(velocity(simulation).y - there.v)};
}

}  // namespace clapotis::tests
