#include <cmath>
#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/clouds.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

Scene scene(const std::string& name) { return stage4::stage().scene(name); }

/// A dam break in steps of so many times its acoustic limit at the start, when nothing moves.
Simulation dam_break(double times, const std::string& density, const std::string& integrator) {
  const double h = 1.5 * 0.1, c = 10 * std::sqrt(2 * 9.81 * 2);
  return Simulation(scene("dam_break"),
                    typed({{"spacing", 0.1}, {"density", density}, {"dt", times * 1.55 * h / c}}),
                    integrator);
}

void refused(const std::string& name, const Values& values, const std::vector<std::string>& parts) {
  for (const auto& part : parts)
    CHECK_THROWS_WITH(Simulation(scene(name), typed(values)), ContainsSubstring(part));
  CHECK_THROWS_AS(Simulation(scene(name), typed(values)), BadInput);
}

}  // namespace

TEST_CASE("at the acoustic limit a dam break stays bounded", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const std::string integrator = GENERATE("symplectic_euler", "velocity_verlet", "rk4");
  auto sim = dam_break(1, density, integrator);
  CHECK(sim.warnings().empty());
  CAPTURE(density, integrator);
  REQUIRE_NOTHROW(run_steps(sim, 500));
  // a jet that a wall turns up is faster than the fall of 2 m, but hardly twice as fast
  CHECK(max_speed(sim.particles()) < 2 * std::sqrt(2 * 9.81 * 2));
}

TEST_CASE("a step 2 or 5 times the acoustic limit is announced, and found out within a few steps",
          "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const double times = GENERATE(2.0, 5.0);
  // the limit is that of the two symplectic schemes; Runge-Kutta 4 bears 1.6 times as much of it
  const std::string integrator = times == 2
                                     ? GENERATE(as<std::string>(), "symplectic_euler", "velocity_verlet")
                                     : GENERATE(as<std::string>(), "explicit_euler", "symplectic_euler",
                                                "velocity_verlet", "rk2", "rk4");
  auto sim = dam_break(times, density, integrator), twin = dam_break(times, density, integrator);
  CAPTURE(density, times, integrator);
  REQUIRE(sim.warnings().size() == 1);
  CHECK_THAT(sim.warnings().front(), ContainsSubstring(" is " + std::string(times == 2 ? "2" : "5") +
                                                       " times the acoustic limit 1.55 h/(c + |v|)"));
  const auto diverged = run_until_divergence(sim, times == 2 ? 40 : 10);
  CHECK(diverged.time == Approx(static_cast<double>(diverged.step) * sim.dt()));
  REQUIRE(diverged.particle >= 0);
  REQUIRE(diverged.particle < sim.particles().size());
  CHECK_THAT(diverged.what(), ContainsSubstring("diverged at step " + std::to_string(diverged.step)) &&
                                  ContainsSubstring("particle " + std::to_string(diverged.particle)) &&
                                  ContainsSubstring("times the acoustic limit 1.55 h/(c + |v|)"));
  CHECK(sim.steps() == diverged.step - 1);
  CHECK(all_finite(sim.particles()));
  run_steps(twin, diverged.step - 1);
  CHECK(same_fluid(sim, twin));
}

TEST_CASE("a liquid that gains energy slowly is found out as well", "[stage4]") {
  // explicit Euler lets sound grow by a few per cent in each step: no step by itself is conspicuous
  const std::string density = GENERATE("continuity", "summation");
  auto sim = dam_break(0.6, density, "explicit_euler");
  CAPTURE(density);
  const auto diverged = run_until_divergence(sim, 1500);
  CHECK(sim.steps() == diverged.step - 1);
  CHECK(max_speed(sim.particles()) <= 10 * std::sqrt(2 * 9.81 * 2));  // the sound speed
}

TEST_CASE("the automatic step of a liquid follows its speed, its force and its viscosity", "[stage4]") {
  const double nu = GENERATE(0.0, 10.0);
  Values values{{"spacing", 0.1}, {"cfl", 0.5}};
  if (nu > 0) values.emplace_back("nu", nu);
  Simulation sim(scene("dam_break"), typed(values));
  const double h = 0.15, c = sim.sound_speed();
  CHECK(c == Approx(10 * std::sqrt(2 * 9.81 * 2)).epsilon(4 * epsilon));
  for (long step = 0; step < 50; ++step) {
    const double v = max_speed(sim.particles()), a = greatest_norm(sim.particles().acceleration);
    double dt = std::min(0.5 * h / (c + v), 0.25 * std::sqrt(h / a));
    if (nu > 0) dt = std::min(dt, 0.125 * h * h / nu);
    REQUIRE(sim.dt() == Approx(dt).epsilon(8 * epsilon));
    sim.step();
  }
  CHECK(sim.binding_limit().name == (nu > 0 ? "viscous" : "acoustic"));
}

TEST_CASE("what no liquid can be is refused before anything runs, with name, value and range", "[stage4]") {
  for (const auto* name : {"spacing", "h_over_dx", "reference_density", "sound_speed", "gamma", "tank_width",
                           "tank_height", "column_width", "column_height", "dt", "cfl"})
    for (const auto* value : {"0.0", "-1.0", "nan", "inf", "1e999", "1,5", "much"}) {
      CAPTURE(name, value);
      refused("dam_break", {{name, value}},
              {std::string(name) + " = " + value, std::string(name) + " must be"});
    }
  for (const auto* name : {"alpha", "delta", "nu", "gravity"})  // these may be 0
    for (const auto* value : {"-1.0", "nan", "-inf"}) {
      CAPTURE(name, value);
      refused("dam_break", {{name, value}},
              {std::string(name) + " = " + value, std::string(name) + " must be >= 0"});
    }
  refused("dam_break", {{"spacing", -0.1}}, {"spacing = -0.1 m is out of range: spacing must be > 0 m"});
  refused("dam_break", {{"sound_speed", 0.0}}, {"sound_speed must be > 0 m/s"});
  refused("dam_break", {{"reference_density", 0.0}}, {"reference_density must be > 0 kg/m^3"});
  refused("dam_break", {{"gamma", 0.5}}, {"gamma = 0.5 is out of range", "gamma must be between 1 and 20"});
  refused("dam_break", {{"particle_mass", 1.0}}, {"particle_mass"});
  refused("dam_break", {{"kernel", "gaussian"}}, {"kernel = gaussian", "cubic_spline, wendland_c2"});
  refused("handout", {{"radius", 0.0}}, {"radius = 0 px is out of range"});
}

TEST_CASE("a column wider or taller than its tank is refused", "[stage4]") {
  const std::string walls = GENERATE("dummy", "reflect");
  refused("dam_break", {{"column_width", 4.5}, {"walls", walls}},
          {"column_width = 4.5 m is outside the walls: column_width must be between 0 and 4 m"});
  refused("dam_break", {{"column_height", 3.5}, {"walls", walls}},
          {"column_height = 3.5 m is outside the walls: column_height must be between 0 and 3 m"});
  refused("still_water", {{"depth", 2.0}, {"walls", walls}}, {"depth = 2", "between 0 and 1.5 m"});
  refused("drop_impact", {{"depth", 2.0}, {"walls", walls}}, {"depth = 2", "between 0 and 1.5 m"});
  CHECK_NOTHROW(
      Simulation(scene("dam_break"), typed({{"spacing", 0.5}, {"column_width", 4.0}, {"walls", walls}})));
}

TEST_CASE("a spacing that leaves no particle, or more than any machine holds, is refused", "[stage4]") {
  refused("dam_break", {{"spacing", 2.5}}, {"spacing = 2.5 leaves no room for a single particle"});
  refused("elliptical_drop", {{"spacing", 5.0}}, {"spacing = 5 leaves no room"});
  refused("dam_break", {{"spacing", 1e-7}}, {"spacing = 1e-07 makes room for more than 1e+08 particles"});
  refused("acoustic", {{"side", 2.0}}, {"side = 2 m is out of range: side must be >= 2.6 m"});
}

TEST_CASE("a change that is refused while a liquid runs changes nothing", "[stage4]") {
  const Values values{{"spacing", 0.1}};
  Simulation sim(scene("dam_break"), typed(values)), twin(scene("dam_break"), typed(values));
  run_steps(sim, 10);
  run_steps(twin, 10);
  CHECK_THROWS_AS(sim.set("alpha", "-1"), BadInput);
  CHECK_THROWS_AS(sim.set("delta", "nan"), BadInput);
  CHECK_THROWS_AS(sim.set("spacing", "0.2"), BadInput);
  run_steps(sim, 10);
  run_steps(twin, 10);
  CHECK(same_fluid(sim, twin));
}

TEST_CASE("water with much artificial viscosity stays calm with the step that is chosen for it", "[stage4]") {
  const auto alpha = GENERATE(as<std::string>{}, "0.5", "1", "4");
  CAPTURE(alpha);
  Simulation tank(stage4::stage().scene("still_water"),
                  {{"spacing", {"0.05"}}, {"h_over_dx", {"1.5"}}, {"alpha", {alpha}}});
  while (tank.time() < 1.5) tank.step();
  CHECK(max_speed(tank.particles()) < 0.01 * std::sqrt(9.81));
}

TEST_CASE("water without weight asks for the speed of its sound", "[stage4]") {
  const auto scene = GENERATE(as<std::string>{}, "still_water", "dam_break");
  CHECK_THROWS_WITH(Simulation(stage4::stage().scene(scene), {{"gravity", {"0"}}}),
                    ContainsSubstring("--set sound_speed=10"));
  Simulation calm(stage4::stage().scene(scene),
                  {{"gravity", {"0"}}, {"sound_speed", {"10"}}, {"spacing", {"0.1"}}});
  for (int k = 0; k < 20; ++k) calm.step();
  CHECK(max_speed(calm.particles()) < 1e-9);
}
