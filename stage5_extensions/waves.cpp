#include <cmath>
#include <numbers>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/tank_motion.hpp"
#include "common/laws/walls.hpp"
#include "common/references/waves.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage4_sph/references.hpp"
#include "stage5_extensions/lines.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/probes.hpp"
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

/// Where the surface is at rest: the liquid is pressed together by its own weight.
double surface(const Parameters& p, double depth) { return stage4::at_rest(p).compressed(depth); }

/// How much of the surface is a wave of wave number k, eta = a cos(k x): a = 2/L sum_j V_j cos(k x_j), the
/// integral of the wave over the liquid.
Measure amplitude_of(double k, double width) {
  return {.name = "wave_amplitude", .unit = "L", .value = [=](const System& s) {
            return 2 / width * s.particles.uniform_mass *
                   ((k * s.position.col(0)).cos() / s.particles.density).sum();
          }};
}

/// Where probes stand: between one wall and the other, or between floor and rim.
std::vector<double> places(Parameters& p, Parameter probes, double end) {
  probes.range = {.low = 0, .high = end};
  return p.numbers(probes);
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
  if (a == 0) return std::move(setup);
  const auto wave = nu > 0 ? viscous_wave(g, k, nu) : ViscousWave{wave_frequency(g, k, depth), 0};
  setup.reference = Reference{
      .name = "linear wave",
      .measure = "|a - a_exact|/a_0",
      .unit = "",
      .source = "Lamb, Hydrodynamics, art. 228 and 349",
      .error =
          [=](const System& s) {
            const double exact = a * std::exp(-wave.decay * s.time) * std::cos(wave.frequency * s.time);
            return std::abs(amplitude.value(s) - exact) / a;
          },
      .positions =
          [=, width = tank.width, level = surface(p, depth)](double t) {
            const double now = a * std::exp(-wave.decay * t) * std::cos(wave.frequency * t);
            return curve(width, [=](double x) { return level + now * std::cos(k * x); });
          },
      .shape = Shape::lines};
  return std::move(setup);
}

/// Water in a tank that begins to sway, or to roll.
Setup sloshing(Parameters& p) {
  auto [fluid, depth, tank, setup] = water_at_rest(p);
  setup.model = water_model<TankMotion>(p, std::move(tank.walls));
  const auto left = elevation("elevation_left", 0, tank.width, fluid, setup.particles),
             right = elevation("elevation_right", tank.width, tank.width, fluid, setup.particles);
  auto& measures = setup.measures;
  measures = {left, right};
  for (const double x : places(p, probe_x, tank.width))
    measures.push_back(elevation("elevation_" + to_text(x), x, tank.width, fluid, setup.particles));
  for (const double y : places(p, probe_y, tank.height)) {
    measures.push_back(pressure("pressure_left_" + to_text(y), {0, y}, fluid));
    measures.push_back(pressure("pressure_right_" + to_text(y), {tank.width, y}, fluid));
  }
  const auto motion = TankMotion::from(p);
  if (motion.amplitude == 0 && motion.angle == 0) return std::move(setup);
  const MovedTank exact{tank.width, depth, motion.gravity, motion.amplitude, motion.angle, motion.omega};
  constexpr Index few = 33;  // points of the surface: each is a sum of 200 modes
  const double greatest = exact.greatest(6 * pi / exact.natural_frequency(1));
  // Half of left less right, for the lattice settles beside the walls in the same way on either side; over
  // the greatest in three natural periods.
  setup.reference = Reference{.name = "linear sloshing",
                              .measure = "|eta - eta_exact|/eta_max",
                              .unit = "",
                              .source = "Faltinsen & Timokha 2009, Sloshing, chapter 5",
                              .error =
                                  [=](const System& s) {
                                    const double eta = (left.value(s) - right.value(s)) / 2;
                                    return std::abs(eta - exact.elevation(0, s.time)) / greatest;
                                  },
                              .positions =
                                  [=, width = tank.width, level = surface(p, depth)](double t) {
                                    return curve(
                                        width, [=](double x) { return level + exact.elevation(x, t); }, few);
                                  },
                              .shape = Shape::lines};
  return std::move(setup);
}

}  // namespace clapotis::stage5
