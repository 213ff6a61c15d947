#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// Viscosity of pairs that approach: f_i = V_i sum_j V_j alpha rho_0 c mu grad W, mu = h v_ij.d/r^2 where
/// v_ij.d < 0, else 0. In 2D it acts like a kinematic viscosity of alpha h c/8. Monaghan & Gingold 1983;
/// Monaghan 1992, whose 0.01 h^2 beside r^2 is left out, for mu d W'/r stays finite without it, and whose
/// mean density of the pair is rho_i rho_j/rho_0 here, which differs by a millionth and needs no division.
struct ArtificialViscosity {
  static constexpr std::string_view name = "artificial_viscosity";
  static constexpr bool dissipates = true;
  double alpha;      ///< >= 0
  double impedance;  ///< rho_0 c h [kg/(L s)]

  static ArtificialViscosity from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    return {p.number({.name = "alpha", .symbol = "alpha", .unit = "", .value = 0.02, .range = not_negative}),
            fluid.state.reference_density * fluid.state.sound_speed * fluid.h};
  }

  auto stress(const auto& /*i*/, const auto& /*j*/, const Meeting& ij) const {
    return alpha * impedance * min(ij.approach, 0.0) * (ij.inverse_distance * ij.inverse_distance);
  }
};
static_assert(Law<ArtificialViscosity> && ActsByStress<ArtificialViscosity>);

}  // namespace clapotis
