#pragma once

#include <cmath>

#include "common/laws/law.hpp"
#include "common/laws/step_limits.hpp"

namespace clapotis {

/// Viscosity of a Newtonian liquid with a free surface: f_i = V_i sum_j V_j 8 rho_0 nu (v_ij.d)/r^2 d W'/r,
/// which tends to m nu lap v. It acts along the line between two particles, so a body that turns as a whole
/// feels nothing, and no stress is left at a free surface; Morris' form (`LaminarViscosity`) brakes such a
/// body, and damps waves at half the rate. Monaghan & Gingold 1983; Colagrossi, Antuono, Souto-Iglesias & Le
/// Touze 2011. Walls slip.
struct NewtonianViscosity {
  static constexpr std::string_view name = "newtonian_viscosity";
  static constexpr bool dissipates = true;
  double nu;         ///< kinematic viscosity [L^2/s]
  double viscosity;  ///< 8 rho_0 nu [kg/(L s)]
  double h;          ///< smoothing length [L]
  double acoustic;   ///< the step that sound allows, 1.55 h/c [s]

  static NewtonianViscosity from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const double nu =
        p.number({.name = "nu", .symbol = "nu", .unit = "L^2/s", .value = 0, .range = not_negative});
    return {nu, 8 * fluid.state.reference_density * nu, fluid.h,
            AcousticStep::stable * fluid.h / fluid.state.sound_speed};
  }
  auto stress(const auto& /*i*/, const auto& /*j*/, const Meeting& ij) const {
    return viscosity * ij.approach * (ij.inverse_distance * ij.inverse_distance);
  }
  /// In a lattice Verlet is stable to 0.056 h^2/nu: waves along their own direction are damped three times as
  /// fast as Morris' form does. They are waves of sound as well, which takes its part: dt/dt_v + (dt/dt_s)^2
  /// = 1.
  [[nodiscard]] StepLimit limit(const Particles& /*particles*/) const {
    const double viscous = 0.055 * h * h / nu, x = 2 * viscous / acoustic;
    return {.name = "viscous",
            .formula = "dt nu/(0.055 h^2) + (dt c/(1.55 h))^2 = 1",
            .limit = 2 * viscous / (1 + std::sqrt(1 + x * x)),
            .share = 0.85};
  }
};
static_assert(Law<NewtonianViscosity> && ActsByStress<NewtonianViscosity> && LimitsStep<NewtonianViscosity>);

}  // namespace clapotis
