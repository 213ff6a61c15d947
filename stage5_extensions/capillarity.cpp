#include <cmath>
#include <numbers>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/surface_tension.hpp"
#include "common/references/capillarity.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

using std::numbers::pi;

Vector centre_of(const System& s) { return {s.position.col(0).mean(), s.position.col(1).mean()}; }

/// A liquid with surface tension; sound is ten times as fast as the shortest wave of the surface.
struct Liquid {
  Fluid fluid;
  double sigma, nu;
};
Liquid liquid(Parameters& p) {
  auto viscosity = stage4::kinematic_viscosity;
  viscosity.range = positive;  // what comes to rest here comes to rest by it
  const double sigma = p.number(SurfaceTension::parameter()), nu = p.number(viscosity);
  const double spacing = p.number(stage4::particle_spacing), rho = p.number(stage4::reference_density);
  return {stage4::liquid(p, std::sqrt(sigma / (rho * spacing)), wendland_continuity), sigma, nu};
}

std::unique_ptr<Model> model(Parameters& p, DummyWalls walls = {}) {
  return std::make_unique<
      FluidModel<WendlandC2, PressureForce, SurfaceTension, NewtonianViscosity, AcousticStep>>(
      p, DensityForm::continuity, std::move(walls));
}

/// The pressure within a third of the radius, by its effect: what the pairs there push each other with, sum
/// V_i V_j stress r^2 W'/r over 4 sum V_i. The pressure of the equation of state is one part of it, for
/// between particles at places not quite even the forces of the tension do not cancel.
Measure pressure_jump(double radius, Parameters& p) {
  const auto fluid = Fluid::from(p);
  return {.name = "pressure_jump",
          .unit = "kg/(L s^2)",
          .value = [=, tension = SurfaceTension::from(p), kernel = WendlandC2(fluid.h)](const System& s) {
            struct Within {
              Vector r;
              FluidParticle<double> particle;
            };
            std::vector<Within> near;
            const Vector centre = centre_of(s);
            for (Index i = 0; i < s.particles.size(); ++i) {
              const Vector r = row(s.position, i) - centre;
              const double rho = s.particles.density(i);
              if (norm(r) < radius / 3 + kernel.support())
                near.push_back({r, {row(s.velocity, i), rho, fluid.mass / rho, s.particles.pressure(i)}});
            }
            double area = 0, push = 0;
            for (const auto& [at, i] : near) {
              if (norm(at) > radius / 3) continue;
              area += i.volume;
              for (const auto& [other, j] : near) {
                const double r = norm(at - other);
                if (r == 0 || r >= kernel.support()) continue;
                const double stress = tension.stress_at(r, i, j) - i.pressure - j.pressure;
                push += i.volume * j.volume * stress * r * r * kernel.slope_over_r(r, 1 / r);
              }
            }
            return push / (4 * area);
          }};
}

/// How long the drop is over how wide, from its second moments: a/b of an ellipse.
Measure stretch() {
  return {.name = "stretch", .unit = "1", .value = [](const System& s) {
            const Vector c = centre_of(s);
            return std::sqrt((s.position.col(0) - c.x).square().mean() /
                             (s.position.col(1) - c.y).square().mean());
          }};
}
/// Where its surface is farthest from the centre, over the radius of the round drop: 1.253 for a square.
Measure farthest(double radius, double spacing) {
  return {.name = "farthest", .unit = "1", .value = [=](const System& s) {
            const Vector c = centre_of(s);
            const double square =
                ((s.position.col(0) - c.x).square() + (s.position.col(1) - c.y).square()).maxCoeff();
            return (std::sqrt(square) + spacing / 2) / radius;
          }};
}

Vectors circle(const Vector& centre, double radius, double from, double to) {
  constexpr Index points = 181;
  Vectors outline(points, 2);
  for (Index k = 0; k < points; ++k) {
    const double angle = from + (to - from) * static_cast<double>(k) / (points - 1);
    outline.row(k) << centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle);
  }
  return outline;
}

Reference round_drop(const Measure& jump, double sigma, double radius) {
  return {.name = "round drop at rest",
          .measure = "|p R/sigma - 1|",
          .unit = "",
          .source = "Laplace 1806",
          .error = [=](const System& s) { return std::abs(jump.value(s) / laplace_jump(sigma, radius) - 1); },
          .positions =
              [=](double) {
                return circle({0, 0}, radius, 0, 2 * pi);
              },
          .shape = Shape::outline};
}

Reference swinging_drop(const Measure& stretch, const DropMode& mode, double deformation) {
  return {.name = "mode n = 2",
          .measure = "|epsilon - epsilon_exact|/epsilon_0",
          .unit = "",
          .source = "Rayleigh 1879, Proc. R. Soc. 29: 71-97",
          .error =
              [=](const System& s) {
                return std::abs(std::log(stretch.value(s)) / (2 * deformation) - mode.at(s.time));
              },
          .positions =
              [=](double t) {
                Vectors outline = circle({0, 0}, mode.radius, 0, 2 * pi);
                outline.col(0) *= std::exp(deformation * mode.at(t));
                outline.col(1) *= std::exp(-deformation * mode.at(t));
                return outline;
              },
          .shape = Shape::outline};
}

/// The angle of the cap of a circle that has the drop's area and its centre of mass.
Measure contact_angle() {
  return {.name = "measured_angle", .unit = "deg", .value = [](const System& s) {
            const double area = s.particles.uniform_mass * (1 / s.particles.density).sum();
            return angle_of_cap(area, s.position.col(1).mean()) * 180 / pi;
          }};
}
Measure height(double spacing) {
  return {.name = "cap_height", .unit = "L", .value = [=](const System& s) {
            return s.position.col(1).maxCoeff() + spacing / 2;
          }};
}

}  // namespace

/// A drop that is not round, at rest, without weight: its surface pulls it round.
Setup capillary_drop(Parameters& p) {
  const double radius = p.number(stage4::drop_radius);
  const bool square = p.choice(drop_shape) == "square";
  const auto [fluid, sigma, nu] = liquid(p);
  const double half_side = std::sqrt(pi) / 2 * radius;
  Vectors places = square ? stage4::block(fluid.spacing, -half_side, half_side, -half_side, half_side)
                          : stage4::disc(fluid.spacing, {0, 0}, radius);
  const double deformation = square ? 0 : p.number(drop_deformation);
  places.col(0) *= std::exp(deformation);
  places.col(1) *= std::exp(-deformation);
  const double rounded = std::sqrt(static_cast<double>(places.rows()) / pi) * fluid.spacing;
  const double room = 1.4 * radius * std::exp(std::abs(deformation));
  Setup setup{.particles = stage4::particles_at(places, p),
              .model = model(p),
              .radius = fluid.spacing / 2,
              .view = {-room, room, -room, room},
              .fluid = fluid,
              .measures = {pressure_jump(rounded, p), stretch(), farthest(rounded, fluid.spacing)}};
  const DropMode mode{rounded, fluid.state.reference_density, sigma, nu};
  setup.reference = deformation == 0 ? round_drop(setup.measures[0], sigma, rounded)
                                     : swinging_drop(setup.measures[1], mode, deformation);
  return setup;
}

/// Half a disc of liquid on a plate, without weight: it spreads or draws back until it meets the plate at
/// the contact angle.
Setup sessile_drop(Parameters& p) {
  const double radius = p.number(stage4::drop_radius);
  const auto fluid = liquid(p).fluid;
  const double theta = p.number(SurfaceTension::angle_parameter()) * pi / 180;
  Vectors places = stage4::disc(fluid.spacing, {0, 0}, radius);
  const Index half = places.rows() / 2;  // its lattice is symmetric, and sorted from below
  places = Vectors(places.bottomRows(half));
  const CircularCap cap{static_cast<double>(half) * fluid.spacing * fluid.spacing, theta};
  const double support = 2 * fluid.h, room = 1.2 * std::max(radius, cap.width() / 2) + support;
  const double thick = wall_thickness(fluid.spacing, support);
  DummyWalls plate(stage4::block(fluid.spacing, -room, room, -thick, 0), fluid, support);
  Setup setup{.particles = stage4::particles_at(places, p),
              .model = model(p, std::move(plate)),
              .radius = fluid.spacing / 2,
              .view = {-room, room, -thick, std::max(1.2 * radius, 1.1 * cap.height())},
              .fluid = fluid,
              .measures = {contact_angle(), height(fluid.spacing)}};
  setup.reference =
      Reference{.name = "circular cap",
                .measure = "|angle - contact angle|",
                .unit = "deg",
                .source = "Young 1805",
                .error = [=, measured = setup.measures[0]](
                             const System& s) { return std::abs(measured.value(s) - theta * 180 / pi); },
                .positions =
                    [=](double) {
                      const double a = cap.radius();
                      return circle({0, -a * std::cos(theta)}, a, pi / 2 - theta, pi / 2 + theta);
                    },
                .shape = Shape::outline};
  return setup;
}

}  // namespace clapotis::stage5
