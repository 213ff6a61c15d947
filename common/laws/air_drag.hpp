#pragma once

#include "common/laws/law.hpp"
#include "common/simulation/model.hpp"

namespace clapotis {

/// Viscous friction of the air: f = -beta v. Handout, section III. Explicit Euler is stable for dt < 2
/// m/beta.
struct AirDrag {
  static constexpr std::string_view name = "air_drag";
  double beta;  ///< [kg/s], >= 0

  static AirDrag from(Parameters& p) {
    return {p.number({.name = "drag", .symbol = "beta", .unit = "kg/s", .value = 0, .range = not_negative})};
  }
  Vector body(const auto& p, Index i, double /*t*/) const { return (-beta / p.mass(i)) * p.velocity(i); }
  double dissipation(const auto& p, Index i, double /*t*/) const {
    return beta * dot(p.velocity(i), p.velocity(i));
  }
  [[nodiscard]] StepLimit limit(const Particles& particles) const {
    return {.name = "drag", .formula = "2 m/beta", .limit = 2 * particles.least_mass() / beta, .share = 0.25};
  }
};
static_assert(Law<AirDrag> && ActsOnBody<AirDrag> && Dissipates<AirDrag> && LimitsStep<AirDrag>);

}  // namespace clapotis
