#pragma once

#include <memory>
#include <random>
#include <string>
#include <utility>

#include "common/laws/contact_spring.hpp"
#include "common/measures/energy.hpp"
#include "common/neighbours/all_pairs.hpp"
#include "common/particles/shapes.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/fused_model.hpp"
#include "common/simulation/scene.hpp"
#include "common/simulation/simulation.hpp"
#include "tests/common/runs.hpp"

/// What the tests of steps 2 and 3 share: discs at places of the test's choice.
namespace clapotis::tests {

/// Discs at places of the test's choice.
struct Discs {
  Vectors position, velocity;
  Column mass;

  explicit Discs(Vectors r)
      : position(std::move(r)),
        velocity(Vectors::Zero(position.rows(), 2)),
        mass(Column::Ones(position.rows())) {}
};

/// A scene of discs of radius 1/2 and stiffness 1 that nothing but their contacts, and the laws `More`, acts
/// on: no weight, no air, no walls.
template <class Search = AllPairs, Law... More>
Scene free_discs(Discs discs) {
  const auto build = [discs = std::move(discs)](Parameters& p) {
    Setup setup{.particles = Particles(discs.position.rows(), 1), .model = nullptr, .radius = 0};
    setup.particles.position = discs.position;
    setup.particles.velocity = discs.velocity;
    setup.particles.add_column("mass", "kg") = discs.mass;
    setup.model = std::make_unique<FusedModel<Search, StoredMass, ContactSpring, More...>>(p);
    setup.radius = p.number(disc_radius);
    return setup;
  };
  return {.name = "free_discs",
          .length_unit = "m",
          .defaults = {{"radius", "0.5"}, {"stiffness", "1"}},
          .build = build};
}

/// The accelerations by the contacts alone, as the sweep of the model computes them.
template <class Search = AllPairs>
Vectors accelerations(const Discs& discs, const Overrides& overrides = {}) {
  Simulation sim(free_discs<Search>(discs), overrides);
  Vectors a;
  sim.look([&](const System& s) { a = s.acceleration; });
  return a;
}

/// Puts the discs of a scene somewhere else; the time step and its limits are found anew.
inline void place(Simulation& sim, const Vectors& position, const Vectors& velocity) {
  sim.system().position = position;
  sim.system().velocity = velocity;
  sim.set("dt", sim.parameters().find("dt")->text());
}

/// Points scattered evenly over a rectangle, the same for the same seed.
inline Vectors random_points(Index n, const Rectangle& room, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  Vectors points(n, 2);
  for (Index i = 0; i < n; ++i) {
    points(i, 0) = between(room.left, room.right);
    points(i, 1) = between(room.bottom, room.top);
  }
  return points;
}

}  // namespace clapotis::tests
