#include <cmath>
#include <limits>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/artificial_viscosity.hpp"
#include "common/laws/driving_force.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/references/draining_tank.hpp"
#include "common/references/film_flow.hpp"
#include "common/references/impinging_jet.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage5_extensions/lines.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/probes.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

template <class... Viscosity>
std::unique_ptr<Model> flow_model(Parameters& p, const Vectors& walls, const Fluid& fluid, OpenEnds ends) {
  return std::make_unique<
      FluidModel<WendlandC2, Gravity, PressureForce, Viscosity..., AcousticStep, ForceStep>>(
      p, DensityForm::continuity, DummyWalls(walls, fluid, 2 * fluid.h), Period{}, std::move(ends));
}

/// The parameter, which must be below `most` as well.
double number_below(Parameters& p, Parameter parameter, double most) {
  parameter.range.high = most;
  return p.number(parameter);
}

/// The two surfaces of the jet, as far as the plate and its height reach.
Vectors free_streamlines(const ImpingingJet& exact, double half_plate, double height) {
  const double near = exact.surface(height);  // x and y may change places
  Vectors right = curve(half_plate - near, [&](double x) { return exact.surface(near + x); });
  right.col(0) += near;
  Vectors left = right;
  left.col(0) *= -1;
  return both(left, right);
}

/// What presses on a level plate with its face at y = 0: the pressure of its first layer, summed up.
double force_on_plate(const System& s, double spacing) {
  const auto& walls = *s.model.wall_particles();
  double sum = 0;
  for (Index k = 0; k < walls.size(); ++k)
    if (walls.places(k, 1) > -spacing) sum += walls.columns.pressure(k) * spacing;
  return sum;
}

}  // namespace

/// A jet falls on a plate and flows off to either side; without weight, unless one is given.
Setup jet(Parameters& p) {
  const double speed = p.number(jet_speed);
  auto weightless = Gravity::parameter();
  weightless.value = 0;
  p.number(weightless);
  const Fluid fluid = stage4::liquid(p, speed, wendland_continuity);
  const double half_plate = p.number(plate_width) / 2, height = p.number(jet_height);
  const double width = number_below(p, jet_width, 2 * half_plate), dx = fluid.spacing;
  const double strip = wall_thickness(fluid.spacing, 2 * fluid.h), plate_end = half_plate + 2 * strip;
  const Vectors plate = stage4::block(dx, -plate_end, plate_end, -strip, 0);
  const Inlet inlet{.rear = {-width / 2, height + strip},
                    .along = {0, -1},
                    .across = {1, 0},
                    .length = strip,
                    .width = width,
                    .spacing = dx};
  const Outlet outlet{.flow = {-half_plate, half_plate, -unbounded, unbounded},
                      .all = {-half_plate - strip, half_plate + strip, -strip, unbounded}};
  Setup setup{
      .particles = stage4::particles_at(stage4::block(dx, -width / 2, width / 2, 0, height + strip), p),
      .model = flow_model<ArtificialViscosity>(p, plate, fluid, {{inlet}, outlet}),
      .radius = dx / 2,
      .view = {-half_plate - strip, half_plate + strip, -strip, height + strip},
      .fluid = fluid,
      .measures = {{"plate_force", "kg/s^2", [=](const System& s) { return force_on_plate(s, dx); }}},
      .colour_by = "pressure"};
  setup.particles.velocity.col(1) = -speed;
  if (p.value("gravity") > 0) return setup;
  const ImpingingJet exact{width, speed, fluid.state.reference_density};
  setup.reference =
      Reference{.name = "free streamlines",
                .measure = "|F - rho U^2 d|/(rho U^2 d)",
                .unit = "",
                .source = "Milne-Thomson, Theoretical Hydrodynamics, 11.42",
                .error = [=](const System& s) { return std::abs(force_on_plate(s, dx) / exact.force() - 1); },
                .positions = [=](double /*t*/) { return free_streamlines(exact, half_plate, height); },
                .shape = Shape::lines};
  return setup;
}

/// A viscous liquid flows down a bed under the part of its weight along it, even and steady, from an inlet to
/// an outlet.
Setup open_channel(Parameters& p) {
  const double depth = p.number(film_depth), nu = p.number(film_viscosity);
  const FilmFlow exact{depth, nu, DrivingForce::from(p).f};
  const double fastest = exact.velocity(depth), g = Gravity::from(p).g;
  const Fluid fluid = stage4::liquid(p, fastest + std::sqrt(2 * g * depth), wendland_continuity);
  const double length = p.number(reach), dx = fluid.spacing,
               strip = wall_thickness(fluid.spacing, 2 * fluid.h);
  const Vectors bed = stage4::block(dx, -2 * strip, length + 2 * strip, -strip, 0);
  const Inlet inlet{
      .rear = {-strip, 0}, .along = {1, 0}, .across = {0, 1}, .length = strip, .width = depth, .spacing = dx};
  const Outlet outlet{.flow = {-unbounded, length, -unbounded, unbounded},
                      .all = {-unbounded, length + strip, -strip, unbounded}};
  Setup setup{.particles = stage4::particles_at(stage4::block(dx, -strip, length + strip, 0, depth), p),
              .model = flow_model<DrivingForce, LaminarViscosity>(p, bed, fluid, {{inlet}, outlet}),
              .radius = dx / 2,
              .view = {-strip, length + strip, -strip, 1.5 * depth},
              .fluid = fluid};
  stage4::rest_under_weight(setup.particles, p, depth);
  for (Index i = 0; i < setup.particles.size(); ++i)
    setup.particles.velocity(i, 0) = exact.velocity(setup.particles.position(i, 1));
  const double scale = 0.3 * length / fastest;  // of the profile that is drawn
  const auto middle = [=](double x) { return soft_strip(x - length / 2, 0.2 * length); };
  setup.measures = {{"flow_rate", "L^2/s", [=](const System& s) {
                       double sum = 0;
                       for (Index i = 0; i < s.particles.size(); ++i)
                         sum += middle(s.position(i, 0)) * s.velocity(i, 0) / s.density(i);
                       return s.particles.uniform_mass * sum;
                     }}};
  setup.reference = Reference{
      .name = "film on a slope",
      .measure = "rms of u - u_exact over U, around the middle",
      .unit = "",
      .source = "Nusselt 1916; Bird, Stewart & Lightfoot, section 2.2",
      .error =
          [=](const System& s) {
            double sum = 0, count = 0;
            for (Index i = 0; i < s.particles.size(); ++i) {
              const double y = std::min(s.position(i, 1), depth);
              const double share = middle(s.position(i, 0));
              sum += share * std::pow(s.velocity(i, 0) - exact.velocity(y), 2);
              count += share;
            }
            return std::sqrt(sum / count) / fastest;
          },
      .positions =
          [=](double /*t*/) {
            const auto profile =
                upright(curve(depth, [=](double y) { return length / 2 + scale * exact.velocity(y); }));
            return both(profile, curve(length, [=](double) { return depth; }));
          },
      .shape = Shape::lines,
      .measured = [=](const System& s) { return velocity_profile(s, length / 2, 0.1 * length, scale); }};
  return setup;
}

/// A tank empties through a slot in its floor, which is opened at t = 0.
Setup draining(Parameters& p) {
  auto weight = Gravity::parameter();
  weight.range = positive;
  const double depth = p.number(stage4::depth), g = p.number(weight);
  const Fluid fluid = stage4::liquid(p, std::sqrt(2 * g * depth), wendland_continuity);
  const double width = p.number(stage4::tank_width), height = p.number(stage4::tank_height);
  number_below(p, stage4::depth, height);
  const double slot = number_below(p, slot_width, width), dx = fluid.spacing,
               floor = wall_thickness(fluid.spacing, 2 * fluid.h);
  const auto beside = [&](double x) { return std::abs(x - width / 2) > slot / 2; };
  const Vectors all = tank_walls(0, width, 0, height, dx, 2 * fluid.h);
  Vectors walls(all.rows(), 2);
  Index count = 0;
  for (Index k = 0; k < all.rows(); ++k)
    if (all(k, 1) > 0 || beside(all(k, 0))) walls.row(count++) = all.row(k);
  walls.conservativeResize(count, 2);

  const double below = -floor - slot;
  const Outlet outlet{.flow = {-unbounded, unbounded, below, unbounded},
                      .all = {-unbounded, unbounded, below - floor, unbounded}};
  Setup setup{.particles = stage4::particles_at(stage4::block(dx, 0, width, 0, depth), p),
              .model = flow_model<ArtificialViscosity>(p, walls, fluid, {{}, outlet}),
              .radius = dx / 2,
              .view = {-floor, width + floor, below - floor, height},
              .fluid = fluid};
  stage4::rest_under_weight(setup.particles, p, depth);
  const DrainingTank exact{width, slot, depth, g};
  const auto level = [=](const System& s) {
    double volume = 0;
    for (Index i = 0; i < s.particles.size(); ++i)
      if (s.position(i, 1) > 0) volume += s.particles.mass(i) / s.density(i);
    return volume / width;
  };
  setup.measures = {{"level", "L", level}};
  setup.reference = Reference{
      .name = "Torricelli's law",
      .measure = "|sqrt(h) - sqrt(h_exact)|/sqrt(h0)",
      .unit = "",
      .source = "Kirchhoff 1869; Lamb, Hydrodynamics, art. 75",
      .error =
          [=](const System& s) {
            return std::abs(std::sqrt(level(s)) - std::sqrt(exact.level(s.time))) / std::sqrt(depth);
          },
      .positions = [=](double t) { return curve(width, [=](double) { return exact.level(t); }); },
      .shape = Shape::lines};
  return setup;
}

}  // namespace clapotis::stage5
