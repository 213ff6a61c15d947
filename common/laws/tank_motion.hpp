#pragma once

#include <cmath>
#include <numbers>

#include "common/laws/law.hpp"

namespace clapotis {

/// A tank that sways along x, X(t) = A (1 - cos W t), and rolls about the middle of its floor,
/// counterclockwise by theta(t) = B (1 - cos W t), W = 2 pi/T, seen from the tank: d = r - (L/2, 0),
///   a = -X''(cos theta, -sin theta) + g (-sin theta, 1 - cos theta)    sway, turned weight (less `Gravity`)
///       + theta'' (d_y, -d_x) + theta'^2 d + 2 theta' (v_y, -v_x)       Euler, centrifugal, Coriolis
/// The walls stand still, so nothing is to be moved, sorted or resolved in time for them; and X' = theta' = 0
/// at the start, so that a liquid at rest is at rest in both frames. The sum is a `field`, which walls bear,
/// but for Coriolis', which needs a velocity and so is a `body`: what the walls lack of it is of second order
/// in the motion.
struct TankMotion {
  static constexpr std::string_view name = "tank_motion";
  double amplitude;  ///< A [L]
  double angle;      ///< B [rad]
  double omega;      ///< W [1/s]
  double middle;     ///< L/2 [L]
  double gravity;    ///< g [L/s^2]

  /// The scene has stated tank_width and gravity.
  static TankMotion from(Parameters& p) {
    using std::numbers::pi;
    return {
        p.number({.name = "amplitude", .symbol = "A", .unit = "L", .value = 0, .range = not_negative}),
        pi / 180 *
            p.number(
                {.name = "angle", .symbol = "B", .unit = "deg", .value = 0, .range = {.low = 0, .high = 45}}),
        2 * pi / p.number({.name = "period", .symbol = "T", .unit = "s", .value = 1.5, .range = positive}),
        p.value("tank_width") / 2, p.value("gravity")};
  }
  Vector field(const Vector& r, double t) const {
    const double swing = omega * omega * std::cos(omega * t), push = amplitude * swing;
    if (angle == 0) return {-push, 0};
    const double x = r.x - middle, y = r.y, theta = angle * (1 - std::cos(omega * t));
    const double rate = turning(t), rate2 = rate * rate, turn = angle * swing;
    return {-push * std::cos(theta) - gravity * std::sin(theta) + turn * y + rate2 * x,
            push * std::sin(theta) + gravity * (1 - std::cos(theta)) - turn * x + rate2 * y};
  }
  Vector body(const auto& p, Index i, double t) const {
    if (angle == 0) return {0, 0};
    const Vector v = p.velocity(i);
    return 2 * turning(t) * Vector{v.y, -v.x};
  }
  double dissipation(const auto& p, Index i, double t) const {
    return -p.mass(i) * dot(field(p.position(i), t), p.velocity(i));
  }

 private:
  /// theta' [1/s]
  [[nodiscard]] double turning(double t) const { return angle * omega * std::sin(omega * t); }
};
static_assert(Law<TankMotion> && ActsAsField<TankMotion> && ActsOnBody<TankMotion> && Dissipates<TankMotion>);

}  // namespace clapotis
