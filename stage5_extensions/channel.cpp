#include <cmath>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/driving_force.hpp"
#include "common/laws/laminar_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/references/channel_start.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

/// The particles of two plates, below y = 0 and above y = d, as many layers as the support needs.
Vectors plates(double length, double depth, double spacing, double support) {
  const double thick = std::ceil(support / spacing - 1e-9) * spacing;
  const Vectors lower = stage4::block(spacing, 0, length, -thick, 0);
  Vectors both(2 * lower.rows(), 2);
  both << lower, lower;
  both.col(1).tail(lower.rows()) = depth - lower.col(1);
  return both;
}

/// |u - u_exact| of the particle that is farthest off, over the fastest speed of the steady flow.
Reference profile(const ChannelStart& exact, double fastest) {
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
          .positions = {}};
}

/// Water at rest between two plates; `Drive` are the laws that set it in motion. The upper plate slides at U.
template <class... Drive>
Setup between_plates(Parameters& p, double force, double speed) {
  const double d = p.number(channel_depth), nu = p.number(stage4::kinematic_viscosity);
  const double fastest = std::max(std::abs(force) * d * d / (8 * nu), std::abs(speed));
  const Fluid fluid = stage4::liquid(p, fastest, wendland_continuity);
  const double support = 2 * fluid.h;
  auto at_least_one_support = channel_length;
  at_least_one_support.range = {.low = support};
  const double length = p.number(at_least_one_support);
  const Period period{.corner = {0, 0}, .length = {length, 0}};
  DummyWalls walls(plates(length, d, fluid.spacing, support), fluid, support, period);
  walls.slide_above(d, speed);
  return {
      .particles = stage4::particles_at(stage4::block(fluid.spacing, 0, length, 0, d), p),
      .model =
          std::make_unique<FluidModel<WendlandC2, Drive..., PressureForce, LaminarViscosity, AcousticStep>>(
              p, DensityForm::continuity, std::move(walls), period),
      .radius = fluid.spacing / 2,
      .view = {0, length, 0, d},
      .reference = profile({.depth = d, .viscosity = nu, .force = force, .plate_speed = speed}, fastest),
      .fluid = fluid};
}

}  // namespace

/// Water between two plates at rest, driven along them from t = 0 on.
Setup poiseuille(Parameters& p) { return between_plates<DrivingForce>(p, DrivingForce::from(p).f, 0); }

/// Water between two plates, of which the upper one slides from t = 0 on.
Setup couette(Parameters& p) { return between_plates(p, 0, p.number(plate_speed)); }

}  // namespace clapotis::stage5
