#include <cmath>
#include <string>

#include "common/simulation/errors.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A hexagonal pack of n x n discs that touch and have been kicked.
Discs kicked_pack(Index n) {
  Discs discs(Vectors(n * n, 2));
  for (Index i = 0; i < n * n; ++i) {
    const auto line = static_cast<double>(i / n), place = static_cast<double>(i % n);
    discs.position.row(i) << 0.99 * (place + line / 2), 0.99 * std::sqrt(0.75) * line;
  }
  discs.velocity = random_points(n * n, {-0.01, 0.01, -0.01, 0.01}, 9);
  return discs;
}

/// Runs until the state is lost, at most so many steps; the sentence, or nothing.
std::string lost(Simulation& sim, long steps, long& at_step) {
  try {
    run_steps(sim, steps);
  } catch (const Diverged& diverged) {
    at_step = diverged.step;
    return diverged.what();
  }
  return "";
}

/// Where a particle that flew from `start` for the path `way` between walls without loss is now.
double folded(double start, double way, double low, double high) {
  const double box = high - low;
  const double unfolded = std::fmod(std::fmod(start - low + way, 2 * box) + 2 * box, 2 * box);
  return unfolded <= box ? low + unfolded : high - (unfolded - box);
}

}  // namespace

TEST_CASE("the automatic step obeys the lightest mass and the stiffest spring, and names the limit",
          "[stage2]") {
  const double mass_ratio = GENERATE(1e-6, 1.0, 1e6);
  const double stiffness = GENERATE(1.5e5, 1e12);
  Simulation sim(stage2::stage().scene("pair"),
                 typed({{"mass_ratio", mass_ratio}, {"stiffness", stiffness}}));
  const double lightest = std::min(1.0, mass_ratio);
  CAPTURE(mass_ratio, stiffness);
  CHECK(sim.binding_limit().name == "contact");
  CHECK(sim.binding_limit().formula == "0.816 sqrt(m/k)");
  CHECK(sim.dt() == Approx(0.5 * 0.816 * std::sqrt(lightest / stiffness)).epsilon(4 * epsilon));
}

TEST_CASE("discs of mass ratio 1e6 on springs of 1e12 collide as their closed form says", "[stage2]") {
  const double mass_ratio = GENERATE(1e-6, 1e6);
  // they begin 1e-6 px before contact, which lasts pi sqrt(mu/k): about 3e-9 or 3e-6 s
  const double gap = 1e-6;
  Simulation sim(stage2::stage().scene("pair"),
                 typed({{"mass_ratio", mass_ratio}, {"stiffness", 1e12}, {"x0", 390 - gap / 2}}));
  const auto start = momentum(sim.particles());
  run_steps(sim, 200);
  const auto& v = sim.particles().velocity;
  CAPTURE(mass_ratio);
  CHECK(v(1, 0) - v(0, 0) == Approx(400).epsilon(0.1));  // w dt = 0.4: one contact is off by up to (w dt)^2/4
  CHECK(momentum(sim.particles()).x == Approx(start.x).epsilon(1e-12));
  CHECK(sim.error() < 0.1 * 400 * sim.time());
}

TEST_CASE("a light disc that a heavy one squeezes against the wall is no divergence", "[stage2]") {
  // each passage to and fro adds twice the speed of the heavy disc: far beyond 10 v0, and right all the same
  Simulation sim(stage2::stage().scene("pair"), typed({{"mass_ratio", 1e6}}));
  double fastest = 0;
  while (sim.time() < 5) {
    sim.step(5);
    fastest = std::max(fastest, max_speed(sim.particles()));
  }
  CHECK(fastest > 2000);
}

TEST_CASE("a step 2 or 5 times the limit is announced, and found out within a few steps", "[stage2]") {
  const double times = GENERATE(1.0, 2.0, 5.0);
  const double dt = times * 0.816;
  Simulation sim(free_discs(kicked_pack(12)), typed({{"dt", dt}}));
  long step = 0;
  const auto sentence = lost(sim, 500, step);
  CAPTURE(times, sentence);
  if (times == 1) {
    CHECK(sentence.empty());
    CHECK(sim.warnings().empty());
    return;
  }
  CHECK_THAT(sim.warnings().front(), ContainsSubstring("times the contact limit 0.816 sqrt(m/k)"));
  CHECK_THAT(sentence,
             ContainsSubstring("is " + to_text(times) + " times the contact limit 0.816 sqrt(m/k)"));
  CHECK(step < 20);
  CHECK(sim.steps() == step - 1);  // it stands on the last good state
  CHECK(sim.particles().position.allFinite());
}

TEST_CASE("a column of discs at twice the limit diverges, and the run names the limit", "[stage2]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("stack");
  Simulation sim(scene, typed({{"dt", 2 * 0.816 / std::sqrt(1.5e5)}, {"drag", 0.0}}));
  long step = 0;
  CHECK_THAT(lost(sim, 1000, step), ContainsSubstring("2 times the contact limit 0.816 sqrt(m/k)"));
  CHECK(step < 200);
}

TEST_CASE("springs that are released, or made stiffer while they are pressed, raise no false alarm",
          "[stage2]") {
  Vectors r(2, 2);
  r << 0, 0, 0.2, 0;
  Simulation sim(free_discs(Discs(r)), typed({{"dt", 0.001}}));  // at rest: no speed to compare with
  CHECK_NOTHROW(run_steps(sim, 100));
  sim.set("stiffness", "10000");
  CHECK_NOTHROW(run_steps(sim, 2000));
  CHECK(sim.energy().kinetic > 1000);
}

TEST_CASE("values that no disc can have are refused before anything runs, with name, value and range",
          "[stage2]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("pair");
  for (const std::string name : {"radius", "mass", "stiffness", "mass_ratio", "dt", "cfl", "width", "height"})
    for (const std::string value : {"0", "-1"}) {
      CAPTURE(name, value);
      CHECK_THROWS_WITH(Simulation(scene, {{name, {value}}}),
                        ContainsSubstring(name + " = " + value) && ContainsSubstring("must be > 0"));
    }
  for (const std::string name : {"radius", "mass", "stiffness", "mass_ratio", "dt", "gravity", "x0", "vx0"})
    for (const std::string value : {"nan", "inf", "-inf", "1e999", "ten", ""}) {
      CAPTURE(name, value);
      CHECK_THROWS_WITH(Simulation(scene, {{name, {value}}}),
                        ContainsSubstring(name + " = " + value) && ContainsSubstring("finite number"));
    }
  CHECK_THROWS_WITH(Simulation(scene, typed({{"radius", -3.0}})), ContainsSubstring("radius = -3 px"));
  CHECK_THROWS_WITH(Simulation(scene, typed({{"restitution", 1.5}})), ContainsSubstring("between 0 and 1"));
  CHECK_THROWS_WITH(Simulation(scene, typed({{"gravity", -9.81}})), ContainsSubstring(">= 0 px/s^2"));
  CHECK_THROWS_WITH(Simulation(scene, typed({{"x0", 5.0}})), ContainsSubstring("between 10 and 790 px"));
  CHECK_THROWS_WITH(Simulation(scene, typed({{"stifness", 5.0}})),
                    ContainsSubstring("did you mean stiffness?"));
  for (const double count : {0.0, 1.5, -1.0, 1e9})
    CHECK_THROWS_WITH(Simulation(stage2::stage().scene("cloud"), typed({{"particles", count}})),
                      ContainsSubstring("particles = "));
}

TEST_CASE("discs that meet too fast for their springs pass through each other, without a closed form",
          "[stage2]") {
  // closing speed 12,000 px/s against 2h sqrt(k/mu) = 10,954 px/s
  Simulation sim(stage2::stage().scene("pair"), typed({{"vx0", 6000.0}, {"dt", 1e-5}}));
  CHECK_FALSE(sim.setup().reference.has_value());
  run_to(sim, 0.06);
  CHECK(std::isnan(sim.error()));
  CHECK(sim.particles().position(0, 0) > sim.particles().position(1, 0));
}

TEST_CASE("a disc that flies into the exact corner leaves it along the diagonal", "[stage2]") {
  const double vx = GENERATE(-1.0, 1.0), vy = GENERATE(-1.0, 1.0);
  Simulation sim(
      stage2::stage().scene("cloud"),
      typed({{"particles", 1.0}, {"gravity", 0.0}, {"drag", 0.0}, {"width", 600.0}, {"dt", 1e-3}}));
  Vectors r(1, 2), v(1, 2);
  r << 300, 300;
  v << 1000 * vx, 1000 * vy;
  place(sim, r, v);
  run_steps(sim, 400);
  const Vector seen = row(sim.particles().velocity, 0), at = row(sim.particles().position, 0);
  CHECK(seen == Vector{-800 * vx, -800 * vy});
  CHECK(std::abs(std::abs(at.x - 300) - std::abs(at.y - 300)) < 400 * 600 * epsilon);  // 400 steps
}

TEST_CASE(
    "a disc that crosses a thousand boxes in one step ends where its reflections put it, and is reported",
    "[stage2]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("cloud");
  const double v = GENERATE(7.8e5, -7.8e5, 1.23456e6, 1e9);
  constexpr double dt = 1;
  Simulation sim(
      scene, typed({{"particles", 1.0}, {"gravity", 0.0}, {"drag", 0.0}, {"restitution", 1.0}, {"dt", dt}}));
  Vectors start(1, 2), velocity(1, 2);
  start << 123, 456;
  velocity << v, -v / 3;
  place(sim, start, velocity);
  sim.step();
  const Vector at = row(sim.particles().position, 0);
  CAPTURE(v);
  // round-off of the path itself
  CHECK(std::abs(at.x - folded(123, v * dt, 10, 790)) < 8 * epsilon * std::abs(v * dt));
  CHECK(std::abs(at.y - folded(456, -v / 3 * dt, 10, 590)) < 8 * epsilon * std::abs(v * dt));
  CHECK(sim.energy().kinetic == Approx(v * v * (1 + 1 / 9.0) / 2));
  CHECK_THAT(sim.warnings().back(), ContainsSubstring("its reflections were counted instead"));
}

TEST_CASE("a speed beyond all measure neither crashes the search nor leaves the box", "[stage2]") {
  const Scene scene = GENERATE(as<Stage>(), stage2::stage(), stage3::stage()).scene("cloud");
  const double v = GENERATE(1e12, 1e24, 1e100, 1e150);
  Simulation sim(scene, typed({{"particles", 20.0}, {"vx0", v}, {"vy0", v}, {"dt", 0.01}}));
  run_steps(sim, 50);
  CAPTURE(v);
  const auto& r = sim.particles().position;
  CHECK((r.col(0) >= 10 && r.col(0) <= 790 && r.col(1) >= 10 && r.col(1) <= 590).all());
}
