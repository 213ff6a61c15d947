#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// Three discs at play within a ring of twelve immovable ones.
Discs caged_discs() {
  constexpr Index ring = 12, inside = 3;
  Discs discs(Vectors(ring + inside, 2));
  const double reach = 0.5 / std::sin(M_PI / ring);  // neighbours of the ring just touch
  for (Index i = 0; i < ring; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / ring;
    discs.position.row(i) << reach * std::cos(angle), reach * std::sin(angle);
    discs.mass(i) = 1e12;
  }
  discs.position.bottomRows(inside) << -0.55, 0.1, 0.5, -0.2, 0.05, 0.75;
  discs.velocity.bottomRows(inside) << 0.2, 0.1, -0.15, 0.05, 0.02, -0.17;
  return discs;
}

/// Four discs in a lattice of twelve immovable ones, so pressed that no kick opens a contact.
Discs pressed_discs() {
  Discs discs(Vectors(16, 2));
  for (Index i = 0; i < 16; ++i) {
    const auto line = static_cast<double>(i / 4), place = static_cast<double>(i % 4);
    discs.position.row(i) << 0.8 * (place + line / 2), 0.8 * std::sqrt(0.75) * line;
    if (i / 4 == 0 || i / 4 == 3 || i % 4 == 0 || i % 4 == 3)
      discs.mass(i) = 1e12;
    else
      discs.velocity.row(i) = 0.1 * random_points(16, {-1, 1, -1, 1}, 3).row(i);
  }
  return discs;
}

/// How far the energy is from where it started, over the kinetic energy at the start.
struct EnergyError {
  double largest = 0, mean_of_first_tenth = 0, mean_of_last_tenth = 0;
};

EnergyError energy_error(const Discs& discs, double dt, long steps) {
  constexpr long every = 10;
  Simulation sim(free_discs(discs), typed({{"dt", dt}}));
  const auto start = sim.energy();
  const double tenth = static_cast<double>(steps / 10 / every);
  EnergyError seen;
  for (long step = 0; step < steps; step += every) {
    run_steps(sim, every);
    const double error = (sim.energy().mechanical() - start.mechanical()) / start.kinetic;
    seen.largest = std::max(seen.largest, std::abs(error));
    if (step < steps / 10) seen.mean_of_first_tenth += error / tenth;
    if (step >= steps - steps / 10) seen.mean_of_last_tenth += error / tenth;
  }
  return seen;
}

}  // namespace

TEST_CASE(
    "over a million steps of Verlet the energy of pressed discs stays near where it was and does not drift",
    "[stage2]") {
  const auto seen = energy_error(pressed_discs(), 0.1, 1000000);
  // the energy that Verlet conserves differs from the true one by terms of (w dt)^2/8, here 0.0075
  CHECK(seen.largest < 0.01);
  CHECK(std::abs(seen.mean_of_last_tenth - seen.mean_of_first_tenth) < 0.05 * seen.largest);
}

TEST_CASE("discs that meet and part again keep their energy to (w dt)^2 per meeting, over a million steps",
          "[stage2]") {
  // Each corner of the force shifts the energy by up to (w dt)^2/4 of what the contact holds, in either
  // direction: a walk at random, 0.013 of the kinetic energy after some ten thousand contacts.
  const auto seen = energy_error(caged_discs(), 0.05 / std::sqrt(2.0), 1000000);
  CHECK(seen.largest < 0.1);
}
