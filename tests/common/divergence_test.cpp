#include <cmath>
#include <limits>
#include <string>

#include "common/simulation/errors.hpp"
#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Thick air: explicit Euler bears dt < 2 m/beta = 0.2 ms.
Values thick_air(double times_the_limit) {
  return {{"drag", 1e4}, {"dt", times_the_limit * 2e-4}, {"vy0", -1.0}};
}

/// Steps until the simulation gives up.
Diverged run_until_divergence(Simulation& simulation, long most) {
  for (long step = 0; step < most; ++step) {
    try {
      simulation.step();
    } catch (const Diverged& diverged) {
      return diverged;
    }
  }
  FAIL("it did not diverge");
  throw std::logic_error("unreachable");
}

}  // namespace

TEST_CASE("at the stability limit the motion stays bounded, at 2 and 5 times the run ends within a few steps",
          "[simulation]") {
  const std::string impacts = GENERATE("located", "clamp");
  const auto in_air = [&](double ratio) {
    auto values = thick_air(ratio);
    values.emplace_back("impacts", impacts);
    return typed(values);
  };
  Simulation calm(drop(), in_air(1), "explicit_euler");
  CHECK(calm.warnings().empty());
  run_steps(calm, 2000);
  CHECK(std::abs(velocity(calm).y) <= 1.01);  // each step turns the speed round: factor 1 - beta dt/m = -1

  const double ratio = GENERATE(2.0, 5.0);
  Simulation simulation(drop(), in_air(ratio), "explicit_euler");
  REQUIRE(simulation.warnings().size() == 1);
  CHECK_THAT(simulation.warnings().front(),
             ContainsSubstring("times the drag limit 2 m/beta: expect the run to diverge"));
  // The speed grows by 2 ratio - 1 in each step, from 1 m/s to the bound of 495 m/s or so; e = 0.8 delays it.
  const auto steps = static_cast<long>(std::log(500) / std::log((2 * ratio - 1) * 0.8)) + 2;
  const auto diverged = run_until_divergence(simulation, steps);
  CHECK(diverged.step == simulation.steps() + 1);
  CHECK(diverged.time == Approx(static_cast<double>(diverged.step) * ratio * 2e-4));
  CHECK(diverged.particle == 0);
  const std::string times = ratio == 2 ? "2 times" : "5 times";
  CHECK_THAT(diverged.what(),
             ContainsSubstring("diverged at step " + std::to_string(diverged.step)) &&
                 ContainsSubstring("particle 0") && ContainsSubstring("beyond all that the scene's energy") &&
                 ContainsSubstring("m/s") && ContainsSubstring(times + " the drag limit 2 m/beta"));
}

TEST_CASE("after a divergence the simulation stands on the last good state, bit for bit", "[simulation]") {
  const std::string integrator = GENERATE("explicit_euler", "rk4", "velocity_verlet");
  const std::string impacts = GENERATE("located", "clamp");
  auto values = thick_air(1.6);  // RK4 bears 2.8 m/beta, Verlet with a predicted velocity 2 m/beta
  values.emplace_back("impacts", impacts);
  Simulation simulation(drop(), typed(values), integrator), twin(drop(), typed(values), integrator);
  const auto diverged = run_until_divergence(simulation, 200);
  run_steps(twin, diverged.step - 1);
  CHECK(same_state(simulation, twin));
  CHECK(simulation.steps() == twin.steps());
  CHECK_THROWS_AS(simulation.step(), Diverged);  // and it says so again
  CHECK(same_state(simulation, twin));
}

TEST_CASE("steps that were cut short are part of the way back to the last good state", "[simulation]") {
  // A run that stops at instants of its own, as a recording does, has steps of many lengths.
  const auto values = thick_air(1.6);
  const double stop = 5.9e-4;
  Simulation simulation(drop(), typed(values), "explicit_euler"),
      twin(drop(), typed(values), "explicit_euler");
  const auto steps_to_stops = [&](Simulation& s) {
    s.step(stop * (std::floor(s.time() / stop * (1 + 1e-12)) + 1));
  };
  long good = 0;
  CHECK_THROWS_AS(
      [&] {
        for (; good < 500; ++good) steps_to_stops(simulation);
      }(),
      Diverged);
  for (long step = 0; step < good; ++step) steps_to_stops(twin);
  REQUIRE(good >= 4);
  CHECK(simulation.steps() == good);
  CHECK(same_state(simulation, twin));
}

TEST_CASE("a number that is not one is found at once, wherever it sits", "[simulation]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const std::string impacts = GENERATE("located", "clamp");
  const int place = GENERATE(range(0, 4));
  const double poison = GENERATE(std::nan(""), std::numeric_limits<double>::infinity());
  for (const auto* scene : {&drop(), &bounce()}) {
    Simulation simulation(*scene, typed({{"impacts", impacts}}), scheme.name);
    Simulation twin(*scene, typed({{"impacts", impacts}}), scheme.name);
    run_steps(simulation, 20);
    run_steps(twin, 20);
    auto& s = simulation.system();
    (place < 2 ? s.position : s.velocity)(0, place % 2) = poison;
    CAPTURE(scene->name, scheme.name, impacts, place, poison);
    try {
      simulation.step();
      FAIL_CHECK("the poisoned state went unnoticed");
    } catch (const Diverged& diverged) {
      CHECK(diverged.step == 21);
      CHECK(diverged.particle == 0);
      CHECK_THAT(diverged.what(), ContainsSubstring("step 21") && ContainsSubstring("is not a number"));
    }
    CHECK(same_state(simulation, twin));
  }
}

TEST_CASE("the particle that is named is the one that went wrong", "[simulation]") {
  const auto stage = stage2::stage();
  Simulation simulation(stage.scene("cloud"), typed({{"particles", 20.0}, {"dt", 1e-3}}));
  run_steps(simulation, 3);
  simulation.system().velocity(3, 0) = 1;
  simulation.system().velocity(7, 1) = 1e5;  // a fall of 600 px ends with 775 px/s
  try {
    simulation.step();
    FAIL("it went unnoticed");
  } catch (const Diverged& diverged) {
    CHECK(diverged.particle == 7);
  }
}

TEST_CASE("where nothing falls no speed is too high, but a NaN is still found", "[simulation]") {
  Simulation simulation(drop(), typed({{"gravity", 0.0}, {"drag", 0.0}, {"dt", 0.01}}));
  simulation.system().velocity(0, 0) = 50;
  CHECK_NOTHROW(simulation.step());
  simulation.system().velocity(0, 0) = std::nan("");
  CHECK_THROWS_AS(simulation.step(), Diverged);
}

TEST_CASE("what a divergence repeats is not counted twice", "[simulation]") {
  // At 1000 box widths per step every step is folded, and one warning counts them.
  Simulation simulation(bounce(), typed({{"vx0", 1e6}, {"dt", 0.8}, {"restitution", 1.0}, {"drag", 0.0}}));
  run_steps(simulation, 10);
  const auto counted = simulation.model().folded;
  const auto evaluations = simulation.system().force_evaluations;
  simulation.system().velocity(0, 0) = std::nan("");
  CHECK_THROWS_AS(simulation.step(), Diverged);
  CHECK(simulation.model().folded == counted);
  CHECK(simulation.system().force_evaluations == evaluations);
}
