#include <cmath>

#include "common/references/dam_break_front.hpp"
#include "common/references/elliptical_drop.hpp"
#include "common/references/square_patch.hpp"
#include "common/simulation/simulation.hpp"
#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

Simulation scene(std::string_view name, const Overrides& overrides = {}) {
  return Simulation(stage4::stage().scene(name), overrides);
}

}  // namespace

TEST_CASE("a free drop stretches like Monaghan's ellipse, the better the finer, and keeps its energy",
          "[stage4]") {
  // Half the error of PySPH at the same resolution, 1.98, 1.03 % (measured for this project), and 1 % of
  // energy.
  const auto [spacing, most] = GENERATE(std::pair{"0.05", 0.0099}, std::pair{"0.025", 0.00515});
  auto drop = scene("elliptical_drop", {{"spacing", {spacing}}});
  const double kinetic = drop.energy().kinetic;
  run_until(drop, 0.76);
  const double exact = EllipticalDrop{1, 1, 1000}.at(0.76).semi_axis_y;
  CAPTURE(spacing, measure(drop, "stretch_outermost"), measure(drop, "stretch_moment"), exact);
  CHECK(std::abs(measure(drop, "stretch_outermost") / exact - 1) < most);
  CHECK(std::abs(measure(drop, "stretch_moment") / exact - 1) < most);
  CHECK(drop.energy().kinetic / kinetic == Approx(1).epsilon(0.01));
}

TEST_CASE("water at rest keeps the pressure of its own weight, and rest", "[stage4]") {
  auto water = scene("still_water");
  double worst = 0, fastest = 0;
  run_until(water, 1);
  while (water.time() < 2) {
    water.step(2);
    worst = std::max(worst, water.error());
    fastest = std::max(fastest, max_speed(water.particles()));
  }
  CHECK(worst < 0.01);                               // of the L2 norm of the exact pressure
  CHECK(fastest < 1e-2 * std::sqrt(9.81 * 1));       // of the speed of a wave in water as deep
  CHECK(water.particles().position.minCoeff() > 0);  // none in the floor or the left wall
}

TEST_CASE("the front of a dam break is one for two resolutions, between the experiment and Ritter's limit",
          "[stage4]") {
  auto coarse = scene("dam_break", {{"spacing", {"0.03125"}}});
  auto fine = scene("dam_break", {{"spacing", {"0.015625"}}});
  const auto start = coarse.energy();
  const double unit = 1 / std::sqrt(2 * 9.81);  // of T, a = 1 m
  for (const double T : {0.83, 1.45, 2.07, 2.69}) {
    run_until(coarse, T * unit);
    run_until(fine, T * unit);
    const double x = measure(coarse, "front_x");
    CAPTURE(T, x, measure(fine, "front_x"));
    CHECK(std::abs(x - measure(fine, "front_x")) < 0.03);  // a dx of the coarse one
    CHECK(x > koshizuka_oka_1996.front(T) - 0.03);         // 0.03 of reading
    CHECK(x < 1 + 2 * T);
  }
  run_until(coarse, 3 * unit);
  // what the comparison with others asks for; the scheme's own error is a hundred times smaller
  CHECK(std::abs(coarse.energy().total() - start.total()) < 0.01 * start.potential);
}

TEST_CASE("the middle of a turning square is under the tension that rigid rotation asks for", "[stage4]") {
  auto patch = scene("square_patch");
  const double crossing = 1 / patch.sound_speed();
  double sum = 0;
  long count = 0;
  while (patch.time() < 2 * crossing) {  // it starts without pressure and swings about the mean
    patch.step(2 * crossing);
    sum += measure(patch, "centre_pressure");
    ++count;
  }
  CHECK(sum / static_cast<double>(count) == Approx(SquarePatch{1, 1, 1000}.pressure(0, 0)).epsilon(0.1));
}

TEST_CASE("a turning square keeps its particles apart until it has turned by one radian", "[stage4]") {
  auto patch = scene("square_patch");
  run_until(patch, 1);
  const auto& r = patch.particles().position;
  double nearest = 1;
  for (Index i = 0; i < r.rows(); ++i)
    for (Index j = 0; j < i; ++j) nearest = std::min(nearest, norm(row(r, i) - row(r, j)));
  CHECK(nearest > 0.4 * 0.02);  // pairs that clump meet at a third of dx and less (epsilon = 0: 0.31)
}
