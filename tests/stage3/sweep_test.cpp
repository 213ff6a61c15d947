#include <cmath>
#include <limits>
#include <vector>

#include "common/neighbours/cell_grid.hpp"
#include "common/simulation/errors.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/brute_force.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

// The sum over n neighbours, each right to 2 units in the last place, in another order: some 1e-15.
constexpr double as_exact = 1e-13;

Discs crowd(Index n, double side, std::uint64_t seed) {
  Discs discs(random_points(n, {-side, side, -side, side}, seed));
  discs.mass = 1 + random_points(n, {0, 9, 0, 1}, seed + 1).col(0);
  return discs;
}

/// A force that grows with the square of d . v_ij, as Monaghan's viscosity does.
struct Approach {
  static constexpr std::string_view name = "approach";
  static constexpr bool reads_velocity = true;

  static Approach from(Parameters&) { return {}; }
  Vec<Pack> pair(const auto& p, auto i, auto j, const Encounter& ij) const {
    const Vector vi = p.velocity(i);
    const Pack approach = dot(ij.separation, Vec<Pack>{vi.x, vi.y} - p.velocity(j));
    return (approach * approach / p.mass(j) * max(1 - ij.distance, 0.0)) * ij.direction;
  }
  [[nodiscard]] double support() const { return 1; }
};
static_assert(Law<Approach> && ActsOnPair<Approach> && ReadsVelocity<Approach>);

}  // namespace

TEMPLATE_TEST_CASE("the sweep sums what the formula says, for every remainder of the pack's width",
                   "[stage3]", AllPairs, CellGrid) {
  for (Index n = 1; n <= 70; ++n)
    for (const double side : {0.3, std::sqrt(static_cast<double>(n)) / 3, 5.0}) {  // dense, even, thin
      const Discs discs = crowd(n, side, static_cast<std::uint64_t>(n));
      const auto exact = brute_force(discs);
      Simulation sim(free_discs<TestType>(discs));
      CAPTURE(n, side);
      sim.look([&](const System& s) { CHECK(difference(s.acceleration, exact) < as_exact); });
      CHECK(sim.energy().elastic == Approx(exact.elastic).epsilon(as_exact).margin(1e-300));
      CHECK(sim.model().count_pairs(sim.particles()).neighbours == exact.neighbours);
    }
}

TEMPLATE_TEST_CASE("the sweep sums what the formula says in a large crowd, a row, a column and a heap",
                   "[stage3]", AllPairs, CellGrid) {
  const std::vector<Rectangle> rooms{
      {0, 40, 0, 40}, {-500, 500, 0, 0.9}, {0, 0.9, -500, 500}, {0, 0.5, 0, 0.5}, {0, 0, 0, 40}};
  for (const auto& room : rooms) {
    Discs discs(random_points(1500, room, 8));
    const auto exact = brute_force(discs);
    Simulation sim(free_discs<TestType>(discs));
    CAPTURE(room.right, room.top);
    sim.look([&](const System& s) { CHECK(difference(s.acceleration, exact) < as_exact); });
    CHECK(sim.model().count_pairs(sim.particles()).neighbours == exact.neighbours);
  }
}

TEMPLATE_TEST_CASE(
    "a disc one unit in the last place from touching another feels nothing, or next to nothing", "[stage3]",
    AllPairs, CellGrid) {
  for (const double gap : {1 - epsilon, 1.0, 1 + epsilon}) {
    Discs discs(Vectors(2, 2));
    discs.position << 0, 0, gap, 0;
    const Vectors a = accelerations<TestType>(discs);
    CAPTURE(gap);
    CHECK(a.abs().maxCoeff() <= 4 * epsilon);
    if (gap > 1) CHECK((a == 0).all());
  }
}

TEMPLATE_TEST_CASE("what is computed for nobody, behind the last particle, stays out of the sum", "[stage3]",
                   AllPairs, CellGrid) {
  for (Index n = 1; n <= 20; ++n) {
    Discs discs = crowd(n, 1, 4);
    discs.velocity = random_points(n, {-1, 1, -1, 1}, 5);
    Simulation sim(free_discs<TestType, Approach>(discs));
    CAPTURE(n);
    sim.look([&](const System& s) { CHECK(s.acceleration.allFinite()); });
  }
}

TEMPLATE_TEST_CASE("a disc without a place disturbs no other, and the run finds it out", "[stage3]", AllPairs,
                   CellGrid) {
  const double lost =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity());
  const Discs whole = crowd(100, 4, 2);
  Discs broken = whole;
  broken.position.row(37).setConstant(lost);
  Discs without = whole;
  without.position.row(37).setConstant(1e9);
  const Vectors a = accelerations<TestType>(broken), expected = accelerations<TestType>(without);
  for (Index i = 0; i < 100; ++i)
    if (i != 37) REQUIRE(norm(row(a, i) - row(expected, i)) < 1e-13);
  Simulation sim(free_discs<TestType>(broken));
  CHECK(sim.model().count_pairs(sim.particles()).neighbours == brute_force(without).neighbours);
  try {
    sim.step();
    FAIL("the run went on");
  } catch (const Diverged& diverged) {
    CHECK(diverged.particle == 37);
  }
}

TEST_CASE("a cloud feels its weight, the air and its contacts, each once", "[stage3]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("cloud");
  const double n = 333;
  Simulation sim(scene, typed({{"particles", n}, {"mass", 3.0}, {"drag", 0.7}}));
  Discs discs(random_points(333, {10, 400, 10, 300}, 5));
  discs.mass = Column::Constant(333, 3);
  const Vectors v = random_points(333, {-100, 100, -100, 100}, 6);
  place(sim, discs.position, v);
  BruteForce exact = brute_force(discs, 1.5e5, 10);
  exact.acceleration += -0.7 / 3 * v;
  exact.acceleration.col(1) -= 500;
  exact.scale += 500;
  sim.look([&](const System& s) { CHECK(difference(s.acceleration, exact) < as_exact); });
}
