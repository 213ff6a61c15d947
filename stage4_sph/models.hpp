#pragma once

#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/tensile_correction.hpp"
#include "common/laws/walls.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage4_sph/liquid.hpp"
#include "stage4_sph/parameters.hpp"

namespace clapotis::stage4 {

/// A liquid with the laws `More` besides those of every scene.
template <class Kernel, class... More>
std::unique_ptr<Model> liquid_model(Parameters& p, DummyWalls walls, const Period& period) {
  const bool sums = p.choice(density_form) == "summation";
  const auto form = sums ? DensityForm::summation : DensityForm::continuity;
  const auto make = [&]<class... Viscosity>(std::type_identity<Viscosity>...) -> std::unique_ptr<Model> {
    if (sums)
      return std::make_unique<FluidModel<Kernel, More..., SummationPressureForce, ArtificialViscosity,
                                         Viscosity..., AcousticStep, ForceStep>>(p, form, std::move(walls),
                                                                                 period);
    return std::make_unique<FluidModel<Kernel, More..., PressureForce, ArtificialViscosity, Viscosity...,
                                       AcousticStep, ForceStep>>(p, form, std::move(walls), period);
  };
  if (p.number(kinematic_viscosity) > 0) return make(std::type_identity<LaminarViscosity>{});
  return make();
}

// Each in a file of its own, for the compiler's sake.
std::unique_ptr<Model> cubic_in_tank(Parameters& p, DummyWalls walls);
std::unique_ptr<Model> wendland_in_tank(Parameters& p, DummyWalls walls);
std::unique_ptr<Model> cubic_free(Parameters& p, const Period& period);
std::unique_ptr<Model> wendland_free(Parameters& p, const Period& period);

}  // namespace clapotis::stage4
