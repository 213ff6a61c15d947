#include <cmath>
#include <numbers>
#include <string>

#include "stage4_sph/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/momenta.hpp"
#include "tests/stage4/brute_force.hpp"
#include "tests/stage4/clouds.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

Scene scene(const std::string& name) { return stage4::stage().scene(name); }

Vectors accelerations(const Cloud& cloud, const Values& values) {
  Simulation sim(scene_of(cloud), typed(values));
  Vectors a;
  sim.look([&](const System& s) { a = s.acceleration; });
  return a;
}

}  // namespace

TEST_CASE("a liquid without walls keeps its momentum and its angular momentum to round-off", "[stage4]") {
  const std::string name = GENERATE("square_patch", "elliptical_drop");
  const std::string density = GENERATE("continuity", "summation");
  Simulation sim(scene(name), typed({{"spacing", 0.05}, {"density", density}}));
  const auto start = momenta(sim.particles());
  run_steps(sim, 200);
  const auto end = momenta(sim.particles());
  CAPTURE(name, density);
  // 200 steps leave a round-off each in every particle; they add up as a walk at random, if that
  CHECK(norm(end.linear - start.linear) < 100 * epsilon * end.magnitude);
  CHECK(std::abs(end.angular - start.angular) < 100 * epsilon * end.angular_magnitude);
}

TEST_CASE("a liquid that crosses the edges of a periodic plane keeps its momentum to round-off", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const std::string integrator =
      GENERATE("explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4");
  Cloud cloud{.position = stage4::block(0.05, 0, 1, 0, 1), .velocity = random_points(400, {0, 1, -1, 1}, 2)};
  cloud.period = {1, 1};
  const double cfl = integrator == "explicit_euler" ? 0.2 : 1;  // it would not last
  Simulation sim(scene_of(cloud), typed({{"density", density}, {"tension", "yes"}, {"cfl", cfl}}),
                 integrator);
  const auto start = momenta(sim.particles());
  run_steps(sim, 50);
  const auto end = momenta(sim.particles());
  CAPTURE(density, integrator);
  CHECK(norm(end.linear - start.linear) < 100 * epsilon * end.magnitude);
  const auto& r = sim.particles().position;
  CHECK(((r >= 0).all() && (r <= 1).all()));
}

TEST_CASE("a particle that has just left a periodic plane feels what it feels at the other edge",
          "[stage4]") {
  Cloud cloud = random_cloud(1, 6);
  cloud.period = {1, 1};
  Cloud drifted = cloud;
  drifted.position.col(0) += 0.0625;  // an eighth of a support: a step of an integrator, before it is over
  drifted.position.col(1) -= 0.125;
  const Values values{{"tension", "yes"}};
  Simulation here(scene_of(cloud), typed(values)), there(scene_of(drifted), typed(values));
  const Vectors a = here.system().acceleration, b = there.system().acceleration;
  CHECK((a - b).abs().maxCoeff() < 1e-11 * a.abs().maxCoeff());
  here.system().evaluate_density_rate();
  there.system().evaluate_density_rate();
  const Column c = here.system().density_rate, d = there.system().density_rate;
  CHECK((c - d).abs().maxCoeff() < 1e-11 * c.abs().maxCoeff());
}

TEST_CASE("a dam break is the same in any units of length, mass and time, bit for bit", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const double L = 0x1p-7, M = 0x1p5, T = 0x1p3;  // powers of two, so that no digit is lost
  Simulation metres(scene("dam_break"), typed({{"spacing", 0.125}, {"density", density}}));
  Simulation other(scene("dam_break"), typed({{"spacing", 0.125 * L},
                                              {"density", density},
                                              {"tank_width", 4 * L},
                                              {"tank_height", 3 * L},
                                              {"column_width", L},
                                              {"column_height", 2 * L},
                                              {"reference_density", 1000 * M / (L * L * L)},
                                              {"gravity", 9.81 * L / (T * T)}}));
  run_steps(metres, 200);
  run_steps(other, 200);
  CHECK(other.time() == T * metres.time());
  CHECK(same_bits(other.particles().position, L * metres.particles().position));
  CHECK(same_bits(other.particles().velocity, L / T * metres.particles().velocity));
  CHECK((other.particles().density == M / (L * L * L) * metres.particles().density).all());
  CHECK(other.energy().total() == M * L / (T * T) * metres.energy().total());
}

TEST_CASE("a dam break is the same in metres and in centimetres", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  Simulation metres(scene("dam_break"), typed({{"spacing", 0.125}, {"density", density}}));
  Simulation other(scene("dam_break"), typed({{"spacing", 12.5},
                                              {"density", density},
                                              {"tank_width", 400.0},
                                              {"tank_height", 300.0},
                                              {"column_width", 100.0},
                                              {"column_height", 200.0},
                                              {"reference_density", 1e-3},
                                              {"gravity", 981.0}}));
  run_steps(metres, 100);
  run_steps(other, 100);
  // The numbers are rounded otherwise, by 1e-16 each. That of a density is 100 times as much of a pressure,
  // c being ten times the speed of the flow, and the collisions of a splash let it grow: by less than a digit
  // in twenty steps.
  CHECK(std::abs(other.time() - metres.time()) < 1e-12);
  CHECK((other.particles().position / 100 - metres.particles().position).abs().maxCoeff() < 1e-10);
  CHECK((other.particles().velocity / 100 - metres.particles().velocity).abs().maxCoeff() < 1e-9);
}

TEST_CASE("the forces in a liquid do not depend on where it is and how it is turned", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const Values values{{"density", density}, {"tension", "yes"}, {"alpha", 0.3}, {"nu", 0.3}};
  const Cloud cloud = random_cloud(1, 3);
  Simulation sim(scene_of(cloud), typed(values));
  const auto exact = brute_force(Liquid::from(sim.parameters()), cloud.position, cloud.velocity,
                                 cloud.density, Vectors(0, 2));
  Vectors expected(cloud.position.rows(), 2);
  expected.col(0) = exact.ax.value;
  expected.col(1) = exact.ay.value;
  for (const double angle : {0.0, std::numbers::pi / 2, std::numbers::pi, 0.1, 2.0, -3.0}) {
    Cloud moved = cloud;
    moved.position = turned(cloud.position, angle);
    moved.velocity = turned(cloud.velocity, angle);
    moved.position.col(0) += 3.5;
    moved.position.col(1) -= 7.25;
    const Vectors wrong = accelerations(moved, values) - turned(expected, angle);
    CAPTURE(density, angle);
    // The places are rounded by 1e-15 of 7 m now, and the nearest two, whose direction and viscosity that
    // changes, are 1 mm apart.
    CHECK((wrong.col(0).abs() / exact.ax.scale).maxCoeff() < 1e-11);
    CHECK((wrong.col(1).abs() / exact.ay.scale).maxCoeff() < 1e-11);
  }
}

TEST_CASE("what a particle of a liquid feels does not depend on the order in which they are listed",
          "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  const Values values{{"density", density}, {"tension", "yes"}, {"tank_width", 1.0}};
  Cloud cloud = random_cloud(1, 4);
  cloud.in_tank = true;
  Cloud reversed = cloud;
  reversed.position = cloud.position.colwise().reverse();
  reversed.velocity = cloud.velocity.colwise().reverse();
  reversed.density = cloud.density.reverse();
  const Vectors a = accelerations(cloud, values);
  const Vectors b = accelerations(reversed, values).colwise().reverse();
  CHECK((a - b).abs().maxCoeff() < 1e-12 * a.abs().maxCoeff());
}

TEST_CASE("the centre of a drop falls along a parabola until it lands, whatever goes on inside", "[stage4]") {
  const double dx = 0.02, support = 2 * 1.5 * dx, g = 9.81, speed = 2;
  Simulation sim(scene("drop_impact"), typed({{"spacing", dx}, {"drop_height", 0.3}}));
  const Index pool = 100 * 25, n = sim.particles().size() - pool;
  REQUIRE(n > 150);
  const auto drop = [&](const Vectors& a) { return a.bottomRows(n); };
  sim.system().density.tail(n) *= 1.01;  // it bursts: 1 % is a pressure of rho c^2/100
  place(sim, sim.particles().position, sim.particles().velocity);
  const Vectors start = sim.particles().position;
  const double height = drop(start).col(1).mean(), middle = drop(start).col(0).mean();
  while (drop(sim.particles().position).col(1).minCoeff() >
         sim.particles().position.topRows(pool).col(1).maxCoeff() + support + 0.01) {
    sim.step();
    const double t = sim.time();
    REQUIRE(drop(sim.particles().position).col(1).mean() ==
            Approx(height - speed * t - g / 2 * t * t).epsilon(0).margin(1e-13));  // 100 steps of round-off
    REQUIRE(drop(sim.particles().position).col(0).mean() == Approx(middle).epsilon(0).margin(1e-13));
  }
  CHECK(sim.time() > 0.03);
  const Vectors spread =
      drop(sim.particles().velocity).rowwise() - drop(sim.particles().velocity).colwise().mean();
  CHECK(spread.abs().maxCoeff() > 0.1);
}
