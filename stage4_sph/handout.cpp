#include "stage4_sph/handout.hpp"

#include <numbers>

#include "common/kernels/cubic_spline.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/handout_forces.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/walls.hpp"
#include "common/simulation/fluid_model.hpp"
#include "common/simulation/quantities.hpp"
#include "stage4_sph/liquid.hpp"
#include "stage4_sph/parameters.hpp"

namespace clapotis::stage4 {
namespace {

const auto columns = detail::number("columns", "", "", 12, {.low = 1, .high = 1e4});
const auto lines = detail::number("lines", "", "", 20, {.low = 1, .high = 1e4});
const auto viscosity_form = detail::choice("viscosity_form", {"printed", "monaghan"});

template <class Viscosity>
using HandoutModel = FluidModel<CubicSpline, Gravity, HandoutPressure, Viscosity, BoxWalls, HandoutStep>;

/// The liquid of particles of radius h and mass m.
Fluid printed_liquid(Parameters& p) {
  const double h = p.number(disc_radius), m = p.number(disc_mass);
  const double fall = p.number(box_height), g = Gravity::from(p).g;
  auto c = sound_speed;
  c.value = 10 * std::sqrt(2 * g * fall);
  p.number(c);
  p.number(polytropic_exponent);
  p.choice([] {
    auto tension = bears_tension;
    tension.choices = {"yes"};
    return tension;
  }());
  p.derive(detail::number("spacing", "dx", "L", 0), 2 * h);
  p.derive(smoothing_length, h);
  p.derive(particle_mass, m);
  p.derive(reference_density, m / (std::numbers::pi * h * h));
  p.choice([] {
    auto sum = density_form;
    sum.choices = {"summation"};
    return sum;
  }());
  return Fluid::from(p);
}

/// `parameter` with another value where nobody gives one.
Parameter usually(Parameter parameter, double value) {
  parameter.value = value;
  return parameter;
}

/// The same column in the same box, with the formulation of all other scenes: particles of 2h, dummy walls,
/// density by continuity.
Setup mended(Parameters& p) {
  const double dx = p.number(usually(particle_spacing, 2 * disc_radius.value));
  const double width = p.number(usually(tank_width, box_width.value));
  const double height = p.number(usually(tank_height, box_height.value)), g = Gravity::from(p).g;
  p.number(usually(reference_density, disc_mass.value / (dx * dx)));
  const auto across = static_cast<double>(p.integer(columns)), up = static_cast<double>(p.integer(lines));
  const Fluid fluid = liquid(p, std::sqrt(2 * g * height));
  auto tank = stage4::tank(p, fluid);
  Vectors places = block(dx, 0, dx * across, 0, dx * up);
  disturb(places, p, dx);
  return {.particles = particles_at(places, p),
          .model = tank_model(p, std::move(tank.walls)),
          .radius = dx / 2,
          .view = {0, width, 0, height},
          .fluid = fluid};
}

}  // namespace

Setup handout(Parameters& p) {
  auto form = formulation;
  form.choices = {"handout", "consistent"};
  if (p.choice(form) == "consistent") return mended(p);
  const Fluid fluid = printed_liquid(p);
  const double h = fluid.h;
  const auto across = static_cast<double>(p.integer(columns)), up = static_cast<double>(p.integer(lines));
  Vectors places = block(2 * h, 0, 2 * h * across, 0, 2 * h * up);
  disturb(places, p, 2 * h);
  Setup setup{.particles = particles_at(places, p),
              .model = nullptr,
              .radius = h,
              .view = {0, p.number(box_width), 0, p.number(box_height)},
              .fluid = fluid};
  if (p.choice(viscosity_form) == "printed")
    setup.model = std::make_unique<HandoutModel<PrintedViscosity>>(p, DensityForm::summation);
  else
    setup.model = std::make_unique<HandoutModel<MonaghanViscosity>>(p, DensityForm::summation);
  return setup;
}

}  // namespace clapotis::stage4
