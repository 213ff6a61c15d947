#pragma once

#include <cmath>
#include <numbers>

#include "common/laws/law.hpp"

namespace clapotis {

/// A tank that sways along x, X(t) = A (1 - cos(2 pi t/T)), seen from the tank: everything in it feels -X''.
/// The walls stand still, so nothing is to be moved, sorted or resolved in time for them; and X'(0) = 0, so
/// that a liquid at rest is at rest in both frames.
struct Sway {
  static constexpr std::string_view name = "sway";
  double amplitude;  ///< A [L]
  double omega;      ///< 2 pi/T [1/s]

  static Sway from(Parameters& p) {
    return {
        p.number({.name = "amplitude", .symbol = "A", .unit = "L", .value = 0.001, .range = not_negative}),
        2 * std::numbers::pi /
            p.number({.name = "period", .symbol = "T", .unit = "s", .value = 1.5, .range = positive})};
  }
  /// X''(t) [L/s^2]
  [[nodiscard]] double acceleration(double t) const {
    return amplitude * omega * omega * std::cos(omega * t);
  }
  Vector field(const Vector& /*r*/, double t) const { return {-acceleration(t), 0}; }
  double dissipation(const auto& p, Index i, double t) const {
    return p.mass(i) * acceleration(t) * p.velocity(i).x;
  }
};
static_assert(Law<Sway> && ActsAsField<Sway> && Dissipates<Sway>);

}  // namespace clapotis
