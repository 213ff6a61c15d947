#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;

TEST_CASE("the last step ends on the wanted instant to the last bit", "[simulation]") {
  const double until = GENERATE(1e-5, 0.3, 1.0, 2.0 / 3, 1.6);
  Simulation simulation(drop(), typed({{"dt", 1e-3}}));
  run_to(simulation, until);
  CHECK(simulation.time() == until);
  simulation.step(until);  // and there it stays
  CHECK(simulation.time() == until);
  CHECK(simulation.steps() == static_cast<long>(std::ceil(until / 1e-3 - 1e-6)));
}

TEST_CASE("a million steps take a million times the time step, not more and not less", "[simulation]") {
  const double dt = 1e-3;
  const long many = 1'000'000;
  Simulation simulation(drop(), typed({{"dt", dt}}), "explicit_euler");
  run_steps(simulation, many - 1);
  // One product and one sum round once each; a sum of a million terms would be 1e-10 off.
  CHECK(simulation.time() == Approx(dt * (many - 1)).epsilon(2 * epsilon).margin(0));
  simulation.step(dt * many);
  CHECK(simulation.time() == dt * many);
  CHECK(simulation.steps() == many);
}

TEST_CASE("time goes on without a jump when the time step changes on the way", "[simulation]") {
  Simulation simulation(drop(), typed({{"dt", 0.01}}));
  run_steps(simulation, 7);
  run_to(simulation, 0.085);
  simulation.set("dt", "0.001");
  run_steps(simulation, 5);
  CHECK(simulation.time() == Approx(0.09).epsilon(2 * epsilon).margin(0));
  simulation.set("dt", "0.01");
  run_steps(simulation, 2);
  CHECK(simulation.time() == Approx(0.11).epsilon(2 * epsilon).margin(0));
  CHECK(simulation.steps() == 16);
}
