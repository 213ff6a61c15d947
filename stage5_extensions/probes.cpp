#include "stage5_extensions/probes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/kernels/wendland_c2.hpp"

namespace clapotis::stage5 {

double soft_strip(double distance, double soft) {
  return std::abs(distance) < soft ? (1 + std::cos(std::numbers::pi * distance / soft)) / (2 * soft) : 0;
}

namespace {

/// How high the water stands at x.
double height_at(double x, double width, double soft, const Particles& particles) {
  double sum = 0;
  for (Index i = 0; i < particles.size(); ++i) {
    const double at = particles.position(i, 0);
    sum += (soft_strip(x - at, soft) + soft_strip(x + at, soft) + soft_strip(2 * width - x - at, soft)) /
           particles.density(i);
  }
  return particles.uniform_mass * sum;
}

}  // namespace

Measure elevation(std::string name, double x, double width, const Fluid& fluid, const Particles& start) {
  const double soft = 4 * fluid.spacing, calm = height_at(x, width, soft, start);
  return {.name = std::move(name), .unit = "L", .value = [=](const System& s) {
            return height_at(x, width, soft, s.particles) - calm;
          }};
}

double pressure_at(const Vector& r, const Fluid& fluid, const Particles& particles) {
  const WendlandC2 kernel(fluid.h);
  // sum W (c_0 + c.d/h - p)^2 is least for N c = f
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Index i = 0; i < particles.size(); ++i) {
    const Vector d = row(particles.position, i) - r;
    if (!(norm(d) < kernel.support())) continue;
    const Eigen::Vector3d term{1, d.x / fluid.h, d.y / fluid.h};
    const double weight = kernel.value(norm(d));
    normal += weight * term * term.transpose();
    right += weight * fluid.state.pressure(particles.density(i)) * term;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (solver.rcond() < 1e-6) return 0;  // a few drops, through which no plane can be laid
  return std::max(0.0, solver.solve(right)(0));
}

Measure pressure(std::string name, const Vector& r, const Fluid& fluid) {
  return {.name = std::move(name), .unit = "kg/(L s^2)", .value = [=](const System& s) {
            return pressure_at(r, fluid, s.particles);
          }};
}

}  // namespace clapotis::stage5
