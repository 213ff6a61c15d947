#pragma once

#include "common/laws/law.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/quantities.hpp"

namespace clapotis {

/// Viscosity of a Newtonian liquid: f_i = V_i sum_j V_j 2 rho_0 nu W'/r v_ij, which tends to m nu lap v.
/// Morris, Fox & Zhu 1997. At a wall that lets nothing slip the wall's particles carry the mirrored velocity
/// (Adami, Hu & Adams 2012); at one that lets all slip there is no friction.
struct LaminarViscosity {
  static constexpr std::string_view name = "laminar_viscosity";
  static constexpr bool dissipates = true;
  double nu;         ///< kinematic viscosity [L^2/s], > 0
  double viscosity;  ///< 2 rho_0 nu [kg/(L s)]
  double at_walls;   ///< the same at walls; 0 where they let all slip
  double h;          ///< smoothing length [L]

  static LaminarViscosity from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const double nu =
        p.number({.name = "nu", .symbol = "nu", .unit = "L^2/s", .value = 0, .range = not_negative});
    const bool slips = p.choice(slip_along_walls) == "free";
    const double viscosity = 2 * fluid.state.reference_density * nu;
    return {nu, viscosity, slips ? 0 : viscosity, fluid.h};
  }
  auto friction(const auto& /*i*/, const auto& /*j*/, const Meeting& /*ij*/) const { return Pack(viscosity); }
  auto wall_friction(const auto& /*i*/, const auto& /*j*/, const Meeting& /*ij*/) const {
    return Pack(at_walls);
  }

  [[nodiscard]] StepLimit limit(const Particles& /*particles*/) const {
    constexpr double stable = 0.145, share = 0.125;  // in a lattice Verlet is stable to 0.147 to 0.18
    return {
        .name = "viscous", .formula = "0.145 h^2/nu", .limit = stable * h * h / nu, .share = share / stable};
  }
};
static_assert(Law<LaminarViscosity> && ActsByFriction<LaminarViscosity> && RubsWalls<LaminarViscosity>);

}  // namespace clapotis
