#include "common/measures/energy.hpp"

#include <cmath>

#include "common/simulation/model.hpp"

namespace clapotis {
namespace {

Vector weighted_mean_sum(const Particles& p, const Vectors& a, double& mass) {
  Vector sum{0, 0};
  mass = 0;
  for (Index i = 0; i < p.size(); ++i) {
    const double m = p.mass(i);
    sum += m * row(a, i);
    mass += m;
  }
  return sum;
}

}  // namespace

Energy energy(System& s) {
  const auto stored = s.model.stored_energy(s.particles);
  double kinetic = 0;
  for (Index i = 0; i < s.particles.size(); ++i) {
    const Vector v = row(s.velocity, i);
    kinetic += s.particles.mass(i) / 2 * dot(v, v);
  }
  return {.kinetic = kinetic,
          .potential = stored.potential,
          .elastic = stored.elastic,
          .dissipated = s.dissipated_energy};
}

Vector momentum(const Particles& particles) {
  double mass = 0;
  return weighted_mean_sum(particles, particles.velocity, mass);
}

Vector centre_of_mass(const Particles& particles) {
  double mass = 0;
  const Vector sum = weighted_mean_sum(particles, particles.position, mass);
  return (1 / mass) * sum;
}

double max_speed(const Particles& particles) {
  return particles.size() == 0
             ? 0
             : std::sqrt(particles.velocity.square().rowwise().sum().maxCoeff<Eigen::PropagateNaN>());
}

}  // namespace clapotis
