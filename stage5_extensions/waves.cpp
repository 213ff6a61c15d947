#include <cmath>
#include <numbers>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/sway.hpp"
#include "common/laws/walls.hpp"
#include "common/references/waves.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage4_sph/references.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

using std::numbers::pi;

/// A tank of water at rest, `depth` deep.
struct Water {
  Fluid fluid;
  double depth;
  stage4::Tank tank;
  Setup setup;
};
Water water_at_rest(Parameters& p) {
  auto weight = Gravity::parameter();
  weight.range = positive;  // without it there are no waves
  const double depth = p.number(stage4::depth), g = p.number(weight);
  const Fluid fluid = stage4::liquid(p, std::sqrt(2 * g * depth), wendland_continuity);
  auto tank = stage4::tank(p, fluid);
  stage4::require_inside_tank(p, tank, {stage4::depth});
  Setup setup{.particles = stage4::particles_at(stage4::block(fluid.spacing, 0, tank.width, 0, depth), p),
              .model = {},
              .radius = fluid.spacing / 2,
              .view = {0, tank.width, 0, tank.height},
              .fluid = fluid};
  stage4::rest_under_weight(setup.particles, p, depth);
  return {fluid, depth, std::move(tank), std::move(setup)};
}

template <class... More>
std::unique_ptr<Model> water_model(Parameters& p, DummyWalls walls) {
  return std::make_unique<FluidModel<WendlandC2, Gravity, TankWalls, PressureForce, ArtificialViscosity,
                                     AcousticStep, ForceStep, More...>>(p, DensityForm::continuity,
                                                                        std::move(walls));
}

/// How much of the surface is a wave of wave number k, eta = a cos(k x): a = 2/L sum_j V_j cos(k x_j), the
/// integral of the wave over the liquid.
Measure amplitude_of(double k, double width) {
  return {.name = "wave_amplitude", .unit = "L", .value = [=](const System& s) {
            return 2 / width * s.particles.uniform_mass *
                   ((k * s.position.col(0)).cos() / s.particles.density).sum();
          }};
}

/// How high the liquid stands at x: what is in a strip around x, over the strip's width. The strip has soft
/// edges, `soft` to either side, and goes on behind the walls as in a mirror.
double height_at(double x, double width, double soft, const Particles& particles) {
  const auto inside = [=](double d) {
    return std::abs(d) < soft ? (1 + std::cos(pi * d / soft)) / (2 * soft) : 0;
  };
  double sum = 0;
  for (Index i = 0; i < particles.size(); ++i) {
    const double at = particles.position(i, 0);
    sum += (inside(x - at) + inside(x + at) + inside(2 * width - x - at)) / particles.density(i);
  }
  return particles.uniform_mass * sum;
}

/// A wave probe: how far the surface at x is above its place at the start.
Measure elevation(std::string name, double x, double width, double spacing, const Particles& start) {
  const double soft = 4 * spacing, calm = height_at(x, width, soft, start);
  return {.name = std::move(name), .unit = "L", .value = [=](const System& s) {
            return height_at(x, width, soft, s.particles) - calm;
          }};
}

}  // namespace

/// Water whose surface is a wave as long as the tank, at its highest and at rest: it swings.
Setup standing_wave(Parameters& p) {
  auto [fluid, depth, tank, setup] = water_at_rest(p);
  const double k = 2 * pi / tank.width, a = p.number(wave_height), g = p.value("gravity");
  auto& r = setup.particles.position;
  for (Index i = 0; i < r.rows(); ++i) {  // moved as the wave moves them, pressed as it presses them
    const double x = r(i, 0), y = r(i, 1), rho = setup.particles.density(i);
    const double up = a * std::sinh(k * y) / std::sinh(k * depth) * std::cos(k * x);
    r(i, 0) -= a * std::cosh(k * y) / std::sinh(k * depth) * std::sin(k * x);
    r(i, 1) += up;
    const double pressure = fluid.state.pressure(rho) +
                            rho * g * (a * std::cosh(k * y) / std::cosh(k * depth) * std::cos(k * x) - up);
    setup.particles.density(i) = fluid.state.density(std::max(pressure, 0.0));
  }
  const double nu = p.number(stage4::kinematic_viscosity);
  setup.model = nu > 0 ? water_model<NewtonianViscosity>(p, std::move(tank.walls))
                       : water_model<>(p, std::move(tank.walls));
  const auto amplitude = amplitude_of(k, tank.width);
  setup.measures = {amplitude};
  const auto wave = nu > 0 ? viscous_wave(g, k, nu) : ViscousWave{wave_frequency(g, k, depth), 0};
  setup.reference = Reference{.name = "linear wave",
                              .measure = "|a - a_exact|/a_0",
                              .unit = "",
                              .source = "Lamb, Hydrodynamics, art. 228 and 349",
                              .error =
                                  [=](const System& s) {
                                    const double exact = a * std::exp(-wave.decay * s.time) *
                                                         std::cos(wave.frequency * s.time);
                                    return std::abs(amplitude.value(s) - exact) / a;
                                  },
                              .positions = {}};
  return std::move(setup);
}

/// Water in a tank that begins to sway.
Setup sloshing(Parameters& p) {
  auto [fluid, depth, tank, setup] = water_at_rest(p);
  setup.model = water_model<Sway>(p, std::move(tank.walls));
  const auto sway = Sway::from(p);
  const SwayedTank exact{tank.width, depth, p.value("gravity"), sway.amplitude, sway.omega};
  const auto left = elevation("elevation_left", 0, tank.width, fluid.spacing, setup.particles),
             right = elevation("elevation_right", tank.width, tank.width, fluid.spacing, setup.particles);
  setup.measures = {left, right};
  // Half of the difference: the lattice settles beside the walls, in the same way on either side.
  setup.reference = Reference{.name = "linear sloshing",
                              .measure = "|eta - eta_exact|/A, half of left less right",
                              .unit = "",
                              .source = "Faltinsen & Timokha 2009, Sloshing, chapter 5",
                              .error =
                                  [=](const System& s) {
                                    const double eta = (left.value(s) - right.value(s)) / 2;
                                    return std::abs(eta - exact.elevation(0, s.time)) / exact.amplitude;
                                  },
                              .positions = {}};
  return std::move(setup);
}

}  // namespace clapotis::stage5
