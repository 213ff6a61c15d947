#include <cmath>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/implicit.hpp"
#include "common/laws/newtonian_viscosity.hpp"
#include "common/laws/pressure_force.hpp"
#include "common/laws/step_limits.hpp"
#include "common/laws/walls.hpp"
#include "common/simulation/fluid_model.hpp"
#include "stage4_sph/references.hpp"
#include "stage5_extensions/parameters.hpp"
#include "stage5_extensions/scenes.hpp"

namespace clapotis::stage5 {
namespace {

/// A nozzle from which the thread comes: what is above its mouth moves down at U, whatever pulls or pushes
/// it.
struct Nozzle {
  static constexpr std::string_view name = "nozzle";
  double mouth, end, speed;  ///< H [L], H + L [L], U [L/s]

  static Nozzle from(Parameters& p) {
    const double mouth = p.value(fall_height.name);
    return {mouth, mouth + p.value(thread_length.name), p.value(thread_speed.name)};
  }
  void settle(System& s, double /*dt*/) const {
    const Vector fed{0, -speed};
    for (Index i = 0; i < s.particles.size(); ++i) {
      if (!(s.position(i, 1) > mouth && s.position(i, 1) < end)) continue;
      const Vector v = row(s.velocity, i);
      s.dissipated_energy += s.particles.mass(i) / 2 * (dot(v, v) - dot(fed, fed));
      s.velocity.row(i) << fed.x, fed.y;
    }
  }
};

/// How far beside its axis the thread is half-way down, over a height of its width; 0 while nothing is there.
Measure sway_of(double axis, double height, double width) {
  return {.name = "sway", .unit = "L", .value = [=](const System& s) {
            double sum = 0, count = 0;
            for (Index i = 0; i < s.particles.size(); ++i) {
              if (std::abs(s.position(i, 1) - height / 2) > width / 2) continue;
              sum += s.position(i, 0) - axis;
              ++count;
            }
            return count > 0 ? sum / count : 0;
          }};
}

}  // namespace

/// A thread of honey that is poured into a dish: it buckles and lays itself in folds, while Re = U d/nu is
/// below about 0.56 and H/d above 10 (Cruickshank 1988; Tome & McKee 1999). The lattice it begins as is
/// disturbed, or else nothing would tell left from right.
Setup honey(Parameters& p) {
  const double d = p.number(thread_width), length = p.number(thread_length), speed = p.number(thread_speed);
  const double nu = p.number(stage4::kinematic_viscosity), g = p.number(Gravity::parameter());
  const double height = p.number(fall_height);
  // What the pressure must hold: the speed of the fall, and friction where the thread is halted (Morris
  // 1997).
  const double fall = std::sqrt(speed * speed + 2 * g * height);
  const Fluid fluid = stage4::liquid(p, std::max(fall, std::sqrt(nu * speed / d)), wendland_continuity);
  auto dish = stage4::tank(p, fluid);
  stage4::require_inside_tank(p, dish, {thread_width});
  const double left = (dish.width - d) / 2;
  Setup setup{.particles = stage4::particles_at(
                  stage4::block(fluid.spacing, left, left + d, height, height + length), p),
              .model = {},
              .radius = fluid.spacing / 2,
              .view = {0, dish.width, 0, height + 2 * d},
              .fluid = fluid,
              .colour_by = "across"};
  auto& particles = setup.particles;
  stage4::disturb(particles.position, p, fluid.spacing);
  particles.velocity.col(1) = -speed;
  particles.add_column("across", "L") = (particles.position.col(0) - dish.width / 2).abs();
  auto model = std::make_unique<FluidModel<WendlandC2, Gravity, TankWalls, Nozzle, PressureForce,
                                           Implicit<NewtonianViscosity>, AcousticStep>>(
      p, DensityForm::continuity, std::move(dish.walls));
  setup.measures = measures_of(model->solved());
  setup.measures.insert(setup.measures.begin(), sway_of(dish.width / 2, height, d));
  setup.model = std::move(model);
  return setup;
}

}  // namespace clapotis::stage5
