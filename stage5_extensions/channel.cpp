#include <cmath>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/driving_force.hpp"
#include "common/laws/implicit.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/references/channel_start.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage5_extensions/lines.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

/// The particles of two plates, below y = 0 and above y = d, as many layers as the support needs.
Vectors plates(double length, double depth, double spacing, double support) {
  const double thick = wall_thickness(spacing, support);
  const Vectors lower = stage4::block(spacing, 0, length, -thick, 0);
  Vectors both(2 * lower.rows(), 2);
  both << lower, lower;
  both.col(1).tail(lower.rows()) = depth - lower.col(1);
  return both;
}

/// |u - u_exact| of the particle that is farthest off, over the fastest speed of the steady flow.
Reference profile(const ChannelStart& exact, double fastest, double length) {
  const double scale = 0.8 * length / fastest;  // of the profile that is drawn
  return {.name = "series solution",
          .measure = "max |u - u_exact|/U",
          .unit = "",
          .source = "Morris, Fox & Zhu 1997, J. Comput. Phys. 136: 214-226",
          .error =
              [=](const System& s) {
                double most = 0;
                for (Index i = 0; i < s.particles.size(); ++i)
                  most =
                      std::max(most, std::abs(s.velocity(i, 0) - exact.velocity(s.position(i, 1), s.time)));
                return most / fastest;
              },
          .positions =
              [=](double t) {
                return upright(curve(exact.depth, [=](double y) { return scale * exact.velocity(y, t); }));
              },
          .shape = Shape::lines,
          .measured = [=](const System& s) { return velocity_profile(s, 0, length, scale); }};
}

/// Backward Euler is of order 1: a flow that has grown for a time t is wrong by about 0.2 dt/t. A five
/// hundredth of what momentum takes to cross the channel keeps the earliest profile of Morris, t = 0.0225
/// d^2/nu, within 2 %.
struct ProfileStep {
  static constexpr std::string_view name = "profile_step";
  double crossing;  ///< d^2/nu [s]

  static ProfileStep from(Parameters& p) {
    const double d = p.value(channel_depth.name);
    return {d * d / p.value(stage4::kinematic_viscosity.name)};
  }
  [[nodiscard]] StepLimit limit(const Particles& /*particles*/) const {
    return {
        .name = "profile", .formula = "d^2/nu", .limit = crossing, .share = 1.0 / 500, .stability = false};
  }
};

/// Water at rest between two plates, driven along them, the upper plate sliding at U, both from t = 0 on.
Setup between_plates(Parameters& p, double force, double speed) {
  const double d = p.number(channel_depth), nu = p.number(stage4::kinematic_viscosity);
  const double fastest = std::abs(force) * d * d / (8 * nu) + std::abs(speed);
  const Fluid fluid = stage4::liquid(p, fastest, wendland_continuity);
  const double support = 2 * fluid.h, thick = wall_thickness(fluid.spacing, support);
  auto at_least_one_support = channel_length;
  at_least_one_support.range = {.low = support};
  const double length = p.number(at_least_one_support);
  const Period period{.corner = {0, 0}, .length = {length, 0}};
  DummyWalls walls(plates(length, d, fluid.spacing, support), fluid, support, period);
  walls.slide_above(d, speed);
  Setup setup{.particles = stage4::particles_at(stage4::block(fluid.spacing, 0, length, 0, d), p),
              .model = {},
              .radius = fluid.spacing / 2,
              .view = {0, length, -thick, d + thick},
              .reference = profile({.depth = d, .viscosity = nu, .force = force, .plate_speed = speed},
                                   fastest, length),
              .fluid = fluid};
  const auto model_with = [&]<class... Viscous>(std::type_identity<Viscous>...) {
    return std::make_unique<FluidModel<WendlandC2, DrivingForce, PressureForce, Viscous..., AcousticStep>>(
        p, DensityForm::continuity, std::move(walls), period);
  };
  if (p.choice(viscous_step) == "explicit") {
    setup.model = model_with(std::type_identity<LaminarViscosity>{});
  } else {
    auto model =
        model_with(std::type_identity<Implicit<LaminarViscosity>>{}, std::type_identity<ProfileStep>{});
    setup.measures = measures_of(model->solved());
    setup.model = std::move(model);
  }
  return setup;
}

}  // namespace

/// Water between two plates: `poiseuille` drives it along them, `couette` lets the upper one slide.
Setup channel(Parameters& p) { return between_plates(p, DrivingForce::from(p).f, p.number(plate_speed)); }

}  // namespace clapotis::stage5
