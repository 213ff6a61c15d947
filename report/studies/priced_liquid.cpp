#include <limits>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/surface_tension.hpp"
#include "common/laws/tensile_correction.hpp"
#include "common/simulation/fluid_model.hpp"
#include "report/studies/one_law_more.hpp"
#include "stage4_sph/liquid.hpp"

namespace clapotis::studies {
namespace {

constexpr double side = 1, spacing = 0.01;

/// Makes the model of a block of liquid, 0 to `side` in both directions.
using Make = std::function<std::unique_ptr<Model>(Parameters&, const Fluid&)>;

/// Ten thousand particles, a little out of their lattice, which a tiny step leaves as they are.
OneLawMore block(const char* law, const Make& make, const char* density = "continuity") {
  const auto build = [=](Parameters& p) {
    const Fluid fluid = stage4::liquid(p, 1);
    Setup setup{.particles = stage4::particles_at(stage4::block(fluid.spacing, 0, side, 0, side), p),
                .model = make(p, fluid),
                .radius = fluid.spacing / 2,
                .fluid = fluid};
    stage4::disturb(setup.particles.position, p, fluid.spacing);
    return setup;
  };
  const Scene scene{.name = "block",
                    .length_unit = "m",
                    .defaults = {{"kernel", "wendland_c2"},
                                 {"spacing", to_text(spacing)},
                                 {"disturbance", "0.1"},
                                 {"density", density},
                                 {"nu", "0.001"},
                                 {"tension", "yes"},
                                 {"dt", "1e-9"}},
                    .build = build};
  return {law, [=] { return std::make_unique<Simulation>(scene); }};
}

template <class... More>
using Liquid = FluidModel<WendlandC2, PressureForce, AcousticStep, More...>;

template <class... More>
Make with() {
  return [](Parameters& p, const Fluid& /*fluid*/) {
    return std::make_unique<Liquid<More...>>(p, DensityForm::continuity);
  };
}

std::unique_ptr<Model> in_tank(Parameters& p, const Fluid& fluid) {
  const double support = 2 * fluid.h;
  return std::make_unique<Liquid<>>(
      p, DensityForm::continuity,
      DummyWalls(tank_walls(0, side, 0, side, fluid.spacing, support), fluid, support));
}

std::unique_ptr<Model> periodic(Parameters& p, const Fluid& /*fluid*/) {
  return std::make_unique<Liquid<>>(p, DensityForm::continuity, DummyWalls{},
                                    Period{.corner = {0, 0}, .length = {side, side}});
}

/// From an inlet at the left to an outlet at the right.
std::unique_ptr<Model> open(Parameters& p, const Fluid& fluid) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const double strip = 2 * fluid.h;
  const Inlet inlet{.rear = {0, 0},
                    .along = {1, 0},
                    .across = {0, 1},
                    .length = strip,
                    .width = side,
                    .spacing = fluid.spacing};
  const Outlet outlet{.flow = {-far, side - strip, -far, far}, .all = {-far, side, -far, far}};
  return std::make_unique<Liquid<>>(p, DensityForm::continuity, DummyWalls{}, Period{},
                                    OpenEnds({inlet}, outlet));
}

}  // namespace

Priced priced_liquid() {
  return {
      .scene = "liquid",
      .itself = block("pressure", with<>()),
      .more = {block("gravity", with<Gravity>()), block("artificial viscosity", with<ArtificialViscosity>()),
               block("laminar viscosity", with<LaminarViscosity>()),
               block("Newtonian viscosity", with<NewtonianViscosity>()),
               block("surface tension", with<SurfaceTension>()),
               block("tensile correction", with<TensileCorrection<WendlandC2>>()),
               block("walls of particles", in_tank), block("inlet and outlet", open),
               block("periodic plane", periodic)}};
}

}  // namespace clapotis::studies
