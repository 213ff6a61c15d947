#pragma once

#include <algorithm>

#include "common/laws/law.hpp"

namespace clapotis {

/// A hand in the liquid and on its tank. Within the reach R of the place r_h where it is, it pulls the liquid
/// towards itself or pushes it away:
///   a = +- s (r_h - r)/R max(0, 1 - |r_h - r|^2/R^2);
/// and a tank that it shakes, with the acceleration A, is seen from the tank: everything in it feels -A. What
/// the hand does is set from outside, between two steps.
struct Hand {
  static constexpr std::string_view name = "hand";
  double strength;  ///< s [L/s^2]
  double reach;     ///< R [L]

  struct Touch {
    Vector at{0, 0};     ///< r_h [L]
    double pull = 0;     ///< 1 pulls, -1 pushes, 0 does nothing
    Vector shake{0, 0};  ///< A [L/s^2]
  };
  Touch touch = {};

  static Hand from(Parameters& p) {
    return {
        p.number(
            {.name = "hand_strength", .symbol = "s", .unit = "L/s^2", .value = 40, .range = not_negative}),
        p.number({.name = "hand_reach", .symbol = "R", .unit = "L", .value = 0.15, .range = positive})};
  }
  /// With other parameters, the hand where it is.
  [[nodiscard]] Hand with(Parameters& p) const {
    auto other = from(p);
    other.touch = touch;
    return other;
  }
  Vector body(const auto& p, Index i, double /*t*/) const { return pulled(p.position(i)); }
  Vector field(const Vector& /*r*/, double /*t*/) const { return -touch.shake; }
  double dissipation(const auto& p, Index i, double /*t*/) const {
    return -p.mass(i) * dot(pulled(p.position(i)) - touch.shake, p.velocity(i));
  }

 private:
  [[nodiscard]] Vector pulled(const Vector& r) const {
    const Vector d = touch.at - r;
    return touch.pull * strength / reach * std::max(0.0, 1 - dot(d, d) / (reach * reach)) * d;
  }
};
static_assert(Law<Hand> && ActsOnBody<Hand> && ActsAsField<Hand> && Dissipates<Hand>);

}  // namespace clapotis
