#include <cmath>

#include "common/neighbours/cell_grid.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

Discs at_one_point(Index n) { return Discs(Vectors::Constant(n, 2, 3.25)); }

Discs apart_by(double dx, double dy) {
  Vectors r(2, 2);
  r << 0, 0, dx, dy;
  return Discs(r);
}

}  // namespace

TEMPLATE_TEST_CASE("discs at one point push each other apart with the full force of their springs",
                   "[stage2]", AllPairs, CellGrid) {
  for (const Index n : {2, 3, 10, 40}) {
    const Vectors a = accelerations<TestType>(at_one_point(n));
    CAPTURE(n);
    CHECK(a.allFinite());
    const double each = static_cast<double>(n - 1);  // k 2h/m = 1 from each of the others
    CHECK(std::abs(a.col(0).sum()) < 10 * epsilon * each);
    CHECK(std::abs(a.col(1).sum()) < 10 * epsilon * each);
    CHECK(a.square().rowwise().sum().maxCoeff() > 0);
    if (n == 2) CHECK(norm(row(a, 0)) == Approx(1).epsilon(4 * epsilon));
    CHECK((accelerations<TestType>(at_one_point(n)) == a).all());
  }
}

TEST_CASE("the direction in which discs at one point part follows from their ids", "[stage2]") {
  Discs discs(Vectors(4, 2));
  discs.position << 0, 0, 0, 0, 10, 0, 10, 0;  // 0 and 1 at one point, 2 and 3 at another
  const Vectors a = accelerations(discs);
  CHECK(norm(row(a, 0) + row(a, 1)) < 4 * epsilon);
  CHECK(norm(row(a, 2) + row(a, 3)) < 4 * epsilon);
  CHECK(norm(row(a, 0) - row(a, 2)) > 0.1);  // other ids, another direction
}

TEMPLATE_TEST_CASE("discs as near as no number can tell are pushed apart as strongly as discs at one point",
                   "[stage2]", AllPairs, CellGrid) {
  for (const double gap : {5e-324, 1e-310, 1e-300, 1e-170, 1.6e-162, 1e-160, 1e-155, 1e-150, 1e-140, 1e-20})
    for (const double slope : {0.0, 1.0}) {
      const Vectors a = accelerations<TestType>(apart_by(gap, slope * gap));
      CAPTURE(gap, slope);
      CHECK(a.allFinite());
      CHECK((a.row(0) == -a.row(1)).all());
      CHECK(norm(row(a, 0)) == Approx(1).epsilon(1e-14));
      if (gap * gap > 1e-300) CHECK(a(1, 0) > 0);  // far enough to tell where the other one is
    }
}

TEST_CASE("two discs of scene pair that start at one point part and fly, and the run says so", "[stage2]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("pair");
  const double v = GENERATE(0.0, 200.0);
  Simulation sim(scene, typed({{"x0", 400.0}, {"vx0", v}, {"dt", 1e-4}}));
  run_steps(sim, 200);
  const auto& p = sim.particles();
  CHECK(p.position.allFinite());
  CHECK(norm(row(p.position, 0) - row(p.position, 1)) > 20);
  CHECK(norm(momentum(p)) < 1e-14 * 200 * 2 * max_speed(p));  // 200 steps of round-off
  // the springs' energy, k (2h)^2/2, and what the discs brought; (w dt)^2/8 of it is Verlet's error, and the
  // force k 2h, which turns round within a step, is wrong over the path v dt of each
  const double energy = 1.5e5 * 400 / 2 + v * v;
  CHECK(std::abs(sim.energy().kinetic - energy) < 1e-3 * energy + 2 * 1.5e5 * 20 * v * sim.dt());
  REQUIRE(sim.warnings().size() == 1);
  CHECK(sim.warnings().front() ==
        "two particles were at one point (times: 1); they were pushed apart in a direction taken from their "
        "ids");
}

TEST_CASE("ten discs released at one point fly apart without a false alarm", "[stage2]") {
  Simulation sim(free_discs(at_one_point(10)), typed({{"dt", 0.01}}));
  run_steps(sim, 2000);
  CHECK(sim.particles().position.allFinite());
  CHECK(sim.energy().elastic == 0);
  CHECK(sim.energy().kinetic == Approx(45 / 2.0).epsilon(0.01));  // 45 springs; they part by jumps of v dt
  CHECK(norm(momentum(sim.particles())) < 1e-12);
}
