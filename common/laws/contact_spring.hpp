#pragma once

#include <cmath>

#include "common/laws/law.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/quantities.hpp"

namespace clapotis {

/// Repulsion of two discs in contact: f_i = k (2h - r) u for r < 2h, else 0; u points from j to i. Each
/// contact stores k (2h - r)^2/2. Handout, section IV. Stable in a hexagonal pack for dt < 0.816 sqrt(m/k)
/// with symplectic Euler or Verlet; a pair alone bears more (w dt < 2), explicit Euler nothing.
struct ContactSpring {
  static constexpr std::string_view name = "contact_spring";
  double k;  ///< stiffness [kg/s^2], > 0
  double h;  ///< radius [L], > 0

  static ContactSpring from(Parameters& p) {
    return {
        p.number({.name = "stiffness", .symbol = "k", .unit = "kg/s^2", .value = 1.5e5, .range = positive}),
        p.number(disc_radius)};
  }
  Vec<Pack> pair(const auto& p, auto i, auto /*j*/, const Encounter& ij) const {
    const Pack overlap = max(2 * h - ij.distance, 0.0);
    return (k / p.mass(i) * overlap) * ij.direction;
  }
  [[nodiscard]] double support() const { return 2 * h; }
  Pack pair_potential(const auto& /*p*/, auto /*i*/, auto /*j*/, const Encounter& ij) const {
    const Pack overlap = max(2 * h - ij.distance, 0.0);
    return k / 2 * overlap * overlap;
  }
  [[nodiscard]] StepLimit limit(const Particles& particles) const {
    return {.name = "contact",
            .formula = "0.816 sqrt(m/k)",
            .limit = 0.816 * std::sqrt(particles.least_mass() / k),
            .share = 0.5};
  }
};
static_assert(Law<ContactSpring> && ActsOnPair<ContactSpring> && StoresPairPotential<ContactSpring>);

}  // namespace clapotis
