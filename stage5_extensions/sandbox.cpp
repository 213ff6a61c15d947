#include <cmath>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/hand.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/walls.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage4_sph/references.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {

/// A tank of water at rest, for the mouse: to be pushed, pulled, added to, erased, walled in and shaken.
Setup sandbox(Parameters& p) {
  const double depth = p.number(stage4::depth), g = Gravity::from(p).g;
  const Fluid fluid = stage4::liquid(p, std::sqrt(2 * g * depth), wendland_continuity);
  auto tank = stage4::tank(p, fluid);
  stage4::require_inside_tank(p, tank, {stage4::depth});
  Setup setup{.particles = stage4::particles_at(stage4::block(fluid.spacing, 0, tank.width, 0, depth), p),
              .model = std::make_unique<FluidModel<WendlandC2, Gravity, Hand, TankWalls, PressureForce,
                                                   ArtificialViscosity, AcousticStep, ForceStep>>(
                  p, DensityForm::continuity, std::move(tank.walls)),
              .radius = fluid.spacing / 2,
              .view = {0, tank.width, 0, tank.height},
              .fluid = fluid};
  stage4::rest_under_weight(setup.particles, p, depth);
  return setup;
}

}  // namespace clapotis::stage5
