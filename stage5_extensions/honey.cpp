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
  double mouth, speed;  ///< H [L], U [L/s]

  static Nozzle from(Parameters& p) { return {p.value(fall_height.name), p.value(thread_speed.name)}; }
  void settle(System& s, double /*dt*/) const {
    const Vector fed{0, -speed};
    for (Index i = 0; i < s.particles.size(); ++i) {
      if (!(s.position(i, 1) > mouth)) continue;
      const Vector v = row(s.velocity, i);
      s.dissipated_energy += s.particles.mass(i) / 2 * (dot(v, v) - dot(fed, fed));
      s.velocity.row(i) << fed.x, fed.y;
    }
  }
};

/// How often the middle of the thread turns back on its way from the lower end to the upper one: the
/// abscissae of its slices, half as high as it is wide at the start, go to and fro by at least a quarter of
/// the width.
Measure folds_of(const Vectors& start, double width) {
  const double slice = width / 2, least = width / 4, bottom = start.col(1).minCoeff();
  const Eigen::ArrayXi slice_of = ((start.col(1) - bottom) / slice).cast<int>();
  return {.name = "folds", .unit = "1", .value = [=](const System& s) {
            Column middle = Column::Zero(slice_of.maxCoeff() + 1), count = middle;
            for (Index i = 0; i < slice_of.size(); ++i) {
              middle(slice_of(i)) += s.position(i, 0);
              count(slice_of(i)) += 1;
            }
            middle /= count;
            int folds = -1, way = 0;  // the first way out of the line is not a fold
            double farthest = middle(0);
            for (const double x : middle) {
              if (way * (x - farthest) >= 0 && way != 0) farthest = x;
              if (std::abs(x - farthest) < least) continue;
              way = x > farthest ? 1 : -1;
              farthest = x;
              ++folds;
            }
            return std::max(folds, 0);
          }};
}

}  // namespace

/// A thread of honey that is poured into a dish: it buckles and lays itself in folds, while Re = U d/nu is
/// below about 0.56 and H/d above 10 (Cruickshank 1988; Tome & McKee 1999).
Setup honey(Parameters& p) {
  const double d = p.number(thread_width), length = p.number(thread_length), speed = p.number(thread_speed);
  const double nu = p.number(stage4::kinematic_viscosity), g = p.number(Gravity::parameter());
  const double height = p.number(fall_height);
  // what the pressure must hold: inertia of the upper end at last, and rubbing where the thread is halted
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
              .fluid = fluid};
  auto& particles = setup.particles;
  stage4::disturb(particles.position, p, fluid.spacing);
  particles.velocity.col(1) = -speed;
  auto model = std::make_unique<FluidModel<WendlandC2, Gravity, TankWalls, Nozzle, PressureForce,
                                           Implicit<NewtonianViscosity>, AcousticStep>>(
      p, DensityForm::continuity, std::move(dish.walls));
  setup.measures = measures_of(model->solved());
  setup.measures.insert(setup.measures.begin(), folds_of(particles.position, d));
  setup.model = std::move(model);
  return setup;
}

}  // namespace clapotis::stage5
