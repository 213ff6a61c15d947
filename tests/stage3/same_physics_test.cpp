#include <cmath>
#include <tuple>

#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

bool same(const Vectors& a, const Vectors& b) { return (a == b).all(); }

/// A crowd of n discs of scene cloud in a box of their size, many of them in contact.
void crowd_together(Simulation& sim) {
  const Index n = sim.particles().size();
  place(sim, random_points(n, {10, 790, 10, 590}, 1), random_points(n, {-50, 50, -50, 50}, 2));
}

}  // namespace

TEST_CASE("the grid moves a cloud as all pairs do", "[stage3]") {
  Simulation pairs(stage2::stage().scene("cloud")), grid(stage3::stage().scene("cloud"));
  REQUIRE(pairs.particles().size() == 500);
  REQUIRE(pairs.dt() == grid.dt());
  double furthest = 0;
  long contacts = 0;
  for (int step = 0; step < 1000; ++step) {
    pairs.step();
    grid.step();
    furthest = std::max(furthest, (pairs.particles().position - grid.particles().position).abs().maxCoeff());
    if (step % 100 == 99) contacts += grid.model().count_pairs(grid.particles()).neighbours;
  }
  CHECK(contacts > 200);         // there was something to disagree about
  CHECK(furthest < 1e-9 * 800);  // the two add up in another order; contacts magnify the round-off of that
}

TEST_CASE("the grid moves a pair and a column as all pairs do, to the last bit", "[stage3]") {
  const std::string scene = GENERATE("pair", "stack");
  Simulation pairs(stage2::stage().scene(scene)), grid(stage3::stage().scene(scene));
  run_steps(pairs, 2000);
  run_steps(grid, 2000);
  CAPTURE(scene);
  // at most two neighbours: a sum of two numbers does not depend on their order
  CHECK(same(pairs.particles().position, grid.particles().position));
  CHECK(pairs.error() == grid.error());
}

TEST_CASE("any number of threads moves a crowd to the same bits", "[stage3]") {
  const std::string integrator =
      GENERATE("explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4");
  const Overrides values = typed({{"particles", 6000.0}, {"radius", 3.5}, {"width", 800.0}, {"y0", 0.0}});
  const auto outcome = [&](int threads) {
    Simulation sim(stage3::stage().scene("cloud"), values, integrator, threads);
    crowd_together(sim);
    run_steps(sim, 15);
    const auto energy = sim.energy();
    return std::tuple(Vectors(sim.particles().position), Vectors(sim.particles().velocity), energy.elastic,
                      energy.potential, energy.dissipated);
  };
  const auto [r, v, elastic, potential, dissipated] = outcome(1);
  CHECK(elastic > 0);
  for (const int threads : {2, 3}) {
    const auto [other_r, other_v, other_elastic, other_potential, other_dissipated] = outcome(threads);
    CAPTURE(integrator, threads);
    CHECK(same(r, other_r));
    CHECK(same(v, other_v));
    CHECK(elastic == other_elastic);
    CHECK(potential == other_potential);
    CHECK(dissipated == other_dissipated);
  }
}

TEST_CASE("any number of threads gives all pairs the same bits", "[stage2][stage3]") {
  const auto outcome = [&](int threads) {
    Simulation sim(stage2::stage().scene("cloud"),
                   typed({{"particles", 5100.0}, {"radius", 3.5}, {"y0", 0.0}}), "velocity_verlet", threads);
    crowd_together(sim);
    run_steps(sim, 2);
    return std::tuple(Vectors(sim.particles().position), Vectors(sim.particles().velocity),
                      sim.energy().total());
  };
  const auto [r, v, total] = outcome(1);
  for (const int threads : {2, 3}) {
    const auto [other_r, other_v, other_total] = outcome(threads);
    CHECK(same(r, other_r));
    CHECK(same(v, other_v));
    CHECK(total == other_total);
  }
}

TEST_CASE("looking at a cloud, or asking what it costs, does not change where it goes", "[stage3]") {
  Simulation alone(stage3::stage().scene("cloud"), typed({{"particles", 300.0}, {"y0", 0.0}})),
      watched(stage3::stage().scene("cloud"), typed({{"particles", 300.0}, {"y0", 0.0}}));
  for (int step = 0; step < 500; ++step) {
    alone.step();
    watched.step();
    if (step % 10 == 0) {
      watched.look([](const System&) {});
      (void)watched.energy();
      (void)watched.model().count_pairs(watched.particles());
      (void)watched.model().neighbourhood(watched.particles(), step % 300);
      (void)watched.model().law_seconds(watched.system(), 1);
    }
  }
  CHECK(same(alone.particles().position, watched.particles().position));
  CHECK(same(alone.particles().velocity, watched.particles().velocity));
}

TEST_CASE("with the grid the work per particle does not grow with their number, with all pairs it does",
          "[stage3]") {
  const auto candidates = [](const Scene& scene, Index n) {
    const double side = 20 * std::sqrt(static_cast<double>(n));
    Simulation sim(
        scene,
        typed(
            {{"particles", static_cast<double>(n)}, {"width", 2 * side}, {"height", 2 * side}, {"y0", 0.0}}));
    place(sim, random_points(n, {10, side, 10, side}, 1), Vectors::Zero(n, 2));  // one to a cell
    return static_cast<double>(sim.model().count_pairs(sim.particles()).candidates) / static_cast<double>(n);
  };
  const Scene grid = stage3::stage().scene("cloud"), pairs = stage2::stage().scene("cloud");
  for (const Index n : {1000, 4000, 16000, 64000}) {
    CAPTURE(n);
    // nine cells of one particle and, since it is there for sure, itself; then less itself. The rim of the
    // smallest cloud has six cells instead of nine: 4 x 31/1000 of a third less. Noise of 1 per cent.
    CHECK(candidates(grid, n) == Approx(9).epsilon(0.08));
  }
  CHECK(candidates(pairs, 1000) == 999);
  CHECK(candidates(pairs, 2000) == 1999);
}

TEST_CASE("the neighbourhood shown to the eye is what the sweep computes with", "[stage3]") {
  Simulation sim(stage3::stage().scene("cloud"), typed({{"particles", 400.0}, {"y0", 0.0}}));
  crowd_together(sim);
  const auto count = sim.model().count_pairs(sim.particles());
  long long candidates = 0, neighbours = 0;
  for (Index i = 0; i < 400; ++i) {
    const auto near = sim.model().neighbourhood(sim.particles(), i);
    REQUIRE(near.has_value());
    CHECK(near->support == 20);
    CHECK(near->cell.y == Approx(20).epsilon(1e-5));
    candidates += static_cast<long long>(near->candidates.size());
    neighbours += static_cast<long long>(near->neighbours.size());
  }
  CHECK(candidates == count.candidates);
  CHECK(neighbours == count.neighbours);
}
