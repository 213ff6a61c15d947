#pragma once

#include <cstring>
#include <string>

#include "common/laws/dummy_walls.hpp"
#include "common/simulation/errors.hpp"
#include "tests/common/runs.hpp"

/// What the tests of stage 4 share: whole states of a fluid, and how a run ends.
namespace clapotis::tests {

inline bool same_bits(const Column& a, const Column& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

/// Whether two runs are at the same instant with the same bits in all columns of their particles.
inline bool same_fluid(const Simulation& a, const Simulation& b) {
  const auto &p = a.particles(), &q = b.particles();
  return same_state(a, b) && a.steps() == b.steps() && same_bits(p.acceleration, q.acceleration) &&
         same_bits(p.density, q.density) && same_bits(p.pressure, q.pressure) &&
         same_bits(p.density_rate, q.density_rate);
}

inline bool all_finite(const Particles& p) {
  return p.position.allFinite() && p.velocity.allFinite() && p.acceleration.allFinite() &&
         p.density.allFinite() && p.pressure.allFinite();
}

/// Steps until the simulation gives up, at most so many times.
inline Diverged run_until_divergence(Simulation& simulation, long most) {
  for (long step = 0; step < most; ++step) {
    try {
      simulation.step();
    } catch (const Diverged& diverged) {
      return diverged;
    }
  }
  throw std::runtime_error("it did not diverge within " + std::to_string(most) + " steps");
}

inline void run_until(Simulation& simulation, double t) {
  while (simulation.time() < t) simulation.step(t);
}

/// What the scene measures under that name.
inline double measure(const Simulation& simulation, std::string_view name) {
  for (const auto& m : simulation.setup().measures)
    if (m.name == name) return m.value(simulation.system());
  throw std::invalid_argument("the scene has no such measure");
}

}  // namespace clapotis::tests
