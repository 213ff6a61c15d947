#include <cmath>

#include "common/laws/hand.hpp"
#include "common/measures/energy.hpp"
#include "common/simulation/tools.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// 30 x 8 particles in a tank of 1.2 m x 1 m.
Simulation small_tank() {
  return {stage5::stage().scene("sandbox"),
          {{"spacing", {"0.04"}}, {"tank_width", {"1.2"}}, {"tank_height", {"1"}}, {"depth", {"0.32"}}}};
}

Index count_within(const Simulation& simulation, const Vector& at, double radius) {
  Index count = 0;
  for (Index i = 0; i < simulation.particles().size(); ++i)
    if (norm(row(simulation.particles().position, i) - at) < radius) ++count;
  return count;
}

}  // namespace

TEST_CASE("a hand that pulls lifts the water, and its work is in the budget", "[stage5]") {
  auto tank = small_tank();
  run_until(tank, 0.05);
  const double start = tank.energy().total(), calm = tank.energy().mechanical();
  hold_hand(tank, {0.6, 0.4}, 1);
  const double height = centre_of_mass(tank.particles()).y;
  run_until(tank, 0.25);
  CHECK(centre_of_mass(tank.particles()).y > height + 0.001);
  CHECK(tank.energy().mechanical() - calm > 5);
  CHECK(std::abs(tank.energy().total() - start) < 0.05 * (tank.energy().mechanical() - calm));
  hold_hand(tank, {0, 0}, 0);
  CHECK(tank.model().hand()->touch.pull == 0);
}

TEST_CASE("a hand that pushes parts the water", "[stage5]") {
  auto tank = small_tank();
  const auto before = count_within(tank, {0.6, 0.2}, 0.1);
  hold_hand(tank, {0.6, 0.2}, -1);
  run_until(tank, 0.1);
  CHECK(count_within(tank, {0.6, 0.2}, 0.1) < before);
}

TEST_CASE("a drop that is added falls and stays, and only where there is room", "[stage5]") {
  auto tank = small_tank();
  const Index before = tank.particles().size();
  const double total = tank.energy().total();
  add_drop(tank, {0.6, 0.7}, 0.12);
  const Index added = tank.particles().size() - before;
  CHECK(std::abs(static_cast<double>(added) - M_PI * 9) < 6);  // pi (R/dx)^2
  CHECK(tank.energy().total() == Approx(total));
  CHECK_THROWS_WITH(add_drop(tank, {0.6, 0.1}, 0.05), Catch::Matchers::ContainsSubstring("no room"));
  CHECK(tank.particles().size() == before + added);
  run_until(tank, 0.5);
  CHECK(all_finite(tank.particles()));
  CHECK(tank.particles().size() == before + added);
  CHECK(centre_of_mass(tank.particles()).y < 0.25);
}

TEST_CASE("what is erased is gone, and the rest flows together", "[stage5]") {
  auto tank = small_tank();
  const Index before = tank.particles().size();
  erase(tank, {0.6, 0.16}, 0.15);
  const Index left = tank.particles().size();
  CHECK(left < before);
  CHECK(count_within(tank, {0.6, 0.16}, 0.15) == 0);
  run_until(tank, 0.5);
  CHECK(count_within(tank, {0.6, 0.16}, 0.1) > 5);
  erase(tank, {0.6, 0.2}, 5);
  CHECK(tank.particles().size() == 0);
  for (int k = 0; k < 20; ++k) tank.step();  // an empty tank goes on
  add_drop(tank, {0.6, 0.5}, 0.1);
  run_until(tank, tank.time() + 0.1);
  CHECK(tank.particles().size() > 10);
}

TEST_CASE("water does not flow through an obstacle that was drawn, nor can one be drawn over it",
          "[stage5]") {
  auto tank = small_tank();
  CHECK_THROWS_WITH(draw_obstacle(tank, {0.6, 0.3}, 0.09),
                    Catch::Matchers::ContainsSubstring("erase it first"));
  CHECK(tank.model().obstacles().rows() == 0);
  // A roof above the left half of the tank keeps off a drop.
  for (double x = 0; x <= 0.6; x += 0.04) draw_obstacle(tank, {x, 0.56}, 0.09);
  const Index before = tank.particles().size();
  add_drop(tank, {0.2, 0.8}, 0.1);
  run_until(tank, 0.6);
  Index above = 0;
  const Index drop = tank.particles().size() - before;
  for (Index i = before; i < tank.particles().size(); ++i)
    if (tank.particles().position(i, 1) > 0.56 || tank.particles().position(i, 0) > 0.6) ++above;
  CHECK(drop > 10);
  CHECK(above == drop);
  erase(tank, {0.3, 0.56}, 1);
  CHECK(tank.model().obstacles().rows() == 0);
}

TEST_CASE("a tank that is shaken sets its water in motion, as weight that turns does", "[stage5]") {
  auto tank = small_tank();
  shake_tank(tank, {3, 0});
  run_until(tank, 0.15);
  CHECK(momentum(tank.particles()).x < -0.5);  // it stays behind
  shake_tank(tank, {0, 0});
  const auto after = tank.parameters().value("gravity");
  CHECK(after == Approx(9.81));
}

TEST_CASE("going back to the last good state repeats what the hand did", "[stage5]") {
  auto one = small_tank(), two = small_tank();
  for (auto* tank : {&one, &two}) {
    for (int k = 0; k < 5; ++k) tank->step();
    hold_hand(*tank, {0.5, 0.3}, 1);
    add_drop(*tank, {0.9, 0.7}, 0.1);
  }
  for (int k = 0; k < 40; ++k) one.step(), two.step();
  CHECK(same_fluid(one, two));
  // a particle that is lost is found, and the state before it is as if it had not been
  for (int k = 0; k < 5; ++k) one.step();
  const double t = one.time();
  one.system().velocity(0, 0) = std::nan("");
  CHECK_THROWS_AS(one.step(), Diverged);
  for (int k = 0; k < 5; ++k) two.step();
  CHECK(one.time() == t);
  CHECK(same_fluid(one, two));
}
