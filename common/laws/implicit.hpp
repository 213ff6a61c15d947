#pragma once

#include "common/laws/law.hpp"
#include "common/simulation/quantities.hpp"

namespace clapotis {

/// Friction that acts with the velocities at the end of the step instead of those at its beginning: after
/// all other laws have acted and left v*, the model solves
///
///   v - dt/m F(v) = v*   (backward Euler),
///
/// F the forces of `Friction` by fluid.hpp, for all particles at once (`simulation/implicit_step.hpp`). This
/// is stable for any dt, so the law's own limit of the step is gone; it is of order 1 in dt. What is in
/// balance, v* - v = dt f/m, is exact for any dt. `Friction` must be linear in the velocities and take energy
/// out of them.
///
/// Walls rub as the fluid itself does, unless `slip` is free. Where nothing slips they carry the mirrored
/// velocity 2 v_w - <v>.
template <FluidLaw Friction>
struct Implicit {
  static constexpr std::string_view name = "implicit_viscosity";
  static constexpr bool implicit = true;
  Friction friction;
  bool slips;        ///< along walls
  double tolerance;  ///< of the solve: |v* + dt/m F(v) - v| over |v|, norms over all particles

  static Implicit from(Parameters& p) {
    return {Friction::from(p), p.choice(slip_along_walls) == "free",
            p.number({.name = "viscous_tolerance",
                      .symbol = "tol",
                      .unit = "",
                      .value = 1e-5,
                      .range = {.low = 1e-14, .high = 0.1}})};
  }
};

}  // namespace clapotis
