#include "common/measures/energy.hpp"

#include <cmath>

#include "common/simulation/model.hpp"

namespace clapotis {
namespace {

/// sum m a
Vector sum_by_mass(const Particles& p, const Vectors& a) {
  Vector sum{0, 0};
  for (Index i = 0; i < p.size(); ++i) sum += p.mass(i) * row(a, i);
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
          .internal = stored.internal,
          .dissipated = s.dissipated_energy};
}

Vector momentum(const Particles& particles) { return sum_by_mass(particles, particles.velocity); }

Vector centre_of_mass(const Particles& particles) {
  double mass = 0;
  for (Index i = 0; i < particles.size(); ++i) mass += particles.mass(i);
  return (1 / mass) * sum_by_mass(particles, particles.position);
}

double max_speed(const Particles& particles) { return greatest_norm(particles.velocity, particles.threads); }

double density_error(const Particles& particles, const Fluid& fluid) {
  return std::sqrt((particles.density / fluid.state.reference_density - 1).square().mean());
}

}  // namespace clapotis
