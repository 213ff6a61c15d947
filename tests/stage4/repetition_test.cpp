#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// A dam break that hits the right wall soon, in some hundred steps; explicit Euler would not live to see it.
Simulation splash(const std::string& density, const std::string& integrator, Values more = {}) {
  more.insert(more.end(), {{"spacing", 0.1}, {"density", density}, {"tank_width", 1.5}});
  if (integrator == "explicit_euler") more.emplace_back("cfl", 0.05);
  return Simulation(stage4::stage().scene("dam_break"), typed(more), integrator);
}

}  // namespace

TEST_CASE("a dam break runs again bit for bit", "[stage4]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const std::string density = GENERATE("continuity", "summation");
  auto once = splash(density, scheme.name), again = splash(density, scheme.name);
  run_steps(once, 60);
  run_steps(again, 60);
  CAPTURE(scheme.name, density);
  CHECK(same_fluid(once, again));
  CHECK(once.steps() == 60);
  CHECK(once.system().time > 0);
}

TEST_CASE("a look at the liquid leaves no trace in it", "[stage4]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const std::string density = GENERATE("continuity", "summation");
  const std::string walls = GENERATE("dummy", "reflect");
  auto watched = splash(density, scheme.name, {{"walls", walls}}),
       alone = splash(density, scheme.name, {{"walls", walls}});
  for (long step = 0; step < 300; ++step) {
    watched.look([](const System&) {});
    watched.step();
    alone.step();
  }
  CAPTURE(scheme.name, density, walls);
  CHECK(same_fluid(watched, alone));
}

TEST_CASE(
    "after a divergence with steps of many lengths the liquid stands on the last good state, bit for bit",
    "[stage4]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const std::string density = GENERATE("continuity", "summation");
  const long good = GENERATE(15L, 33L, 124L);  // 15, 1 and 12 steps after a checkpoint
  auto lost = splash(density, scheme.name), twin = splash(density, scheme.name);
  run_steps(lost, good);
  run_steps(twin, good);
  const double dt = lost.dt();
  lost.system().velocity(7, 1) = 1e30;  // not a NaN: it spoils all it meets before it is found
  const auto diverged = run_until_divergence(lost, 1);
  CAPTURE(scheme.name, density, good);
  CHECK(diverged.step == good + 1);
  CHECK(lost.dt() == dt);
  CHECK(same_fluid(lost, twin));
  run_steps(lost, 40);
  run_steps(twin, 40);
  CHECK(same_fluid(lost, twin));
}
