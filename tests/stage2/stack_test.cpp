#include <cmath>

#include "common/references/stack.hpp"
#include "common/simulation/errors.hpp"
#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

constexpr double gravity = 500, stiffness = 1.5e5, radius = 10;  // of scene stack, with mass 1

double force_on_floor(Simulation& sim) {
  double force = 0;  // the laws' sum does not know the floor: what presses the lowest disc on it
  sim.look([&](const System& s) { force = -s.acceleration(0, 1); });
  return force;
}

}  // namespace

TEST_CASE("in a column at rest the n-th contact from the top overlaps by n m g/k and the floor carries N m g",
          "[stage2]") {
  const double n = GENERATE(1.0, 2.0, 10.0, 25.0);
  const std::string integrator = GENERATE("symplectic_euler", "velocity_verlet", "rk4");
  constexpr double dt = 1e-4;
  Simulation sim(stage2::stage().scene("stack"), typed({{"particles", n}, {"dt", dt}}), integrator);
  run_to(sim, 3);  // the slowest wave, in the column of 25, loses a factor e in some 0.05 s
  CAPTURE(n, integrator);

  // in each step the weight N m g pushes the lowest disc N g dt^2/2 into the floor, which lifts it back
  const double sunk = n * gravity * dt * dt / 2;
  CHECK(sim.error() <= 1.1 * sunk + 1e-10);
  CHECK(force_on_floor(sim) == Approx(n * gravity).margin(stiffness * sunk));
  CHECK(max_speed(sim.particles()) < 0.1 * n * gravity * dt);  // within one step it falls that much, times 10
  const auto& y = sim.particles().position.col(1);
  for (Index contact = 1; contact < static_cast<Index>(n); ++contact) {
    const Index upper = static_cast<Index>(n) - contact;
    const double overlap = 2 * radius - (y(upper) - y(upper - 1));
    CHECK(overlap == Approx(static_cast<double>(contact) * gravity / stiffness).margin(1.1 * sunk + 1e-10));
  }
}

TEST_CASE("a column of discs comes as near to its closed form as dt^2", "[stage2]") {
  const auto error = [](double dt) {
    Simulation sim(stage2::stage().scene("stack"), typed({{"dt", dt}}));
    run_to(sim, 4);
    return sim.error();
  };
  CHECK(std::log10(error(1e-3) / error(1e-4)) == Approx(2).margin(0.1));
}

TEST_CASE("a disc that lies on the floor lies still, whatever the bounciness of the floor", "[stage2]") {
  const double e = GENERATE(0.0, 0.8, 1.0);
  const std::string integrator = GENERATE("symplectic_euler", "velocity_verlet", "rk2", "rk4");
  Simulation sim(stage2::stage().scene("stack"),
                 typed({{"particles", 1.0}, {"restitution", e}, {"drag", 0.0}}), integrator);
  run_steps(sim, 10000);
  CAPTURE(e, integrator);
  CHECK(sim.particles().position(0, 1) == Approx(radius).epsilon(4 * epsilon));
  // a^2 dt^2 - a^2 dt^2 leaves a round-off of it, of which the square root is taken
  CHECK(max_speed(sim.particles()) < 1e-5);
  CHECK(sim.energy().total() == Approx(gravity * radius).epsilon(1e-9));
}

TEST_CASE("a disc bounces as high as its restitution says, for as long as one looks", "[stage2]") {
  const double e = GENERATE(1.0, 0.8);
  Simulation sim(stage2::stage().scene("cloud"),
                 typed({{"particles", 1.0}, {"restitution", e}, {"drag", 0.0}, {"dt", 1e-3}}));
  const double start = sim.energy().total();
  run_to(sim, 200);  // some 150 bounces
  // Verlet is exact on a parabola, and the wall turns the speed that the disc had at the wall
  CHECK(sim.energy().total() == Approx(start).epsilon(1e-9));
  if (e == 1) CHECK(sim.energy().dissipated == 0);
  if (e < 1) CHECK(sim.energy().kinetic < 1e-9);
}

TEST_CASE("a cloud that falls into a box loses its energy to air and walls and lies still", "[stage2]") {
  Simulation sim(stage2::stage().scene("cloud"), typed({{"particles", 60.0}}));
  const double start = sim.energy().mechanical();
  double before = start;
  for (const double t : {1.0, 3.0, 10.0, 30.0}) {
    run_to(sim, t);
    CAPTURE(t);
    CHECK(sim.energy().mechanical() < before);
    before = sim.energy().mechanical();
  }
  run_to(sim, 60);
  CHECK(sim.energy().kinetic < 1e-6 * start);
  CHECK(sim.warnings().empty());
}

TEST_CASE("a column that its springs cannot carry runs without a closed form", "[stage2]") {
  Simulation sim(stage2::stage().scene("stack"), typed({{"stiffness", 100.0}}));
  CHECK_FALSE(sim.setup().reference.has_value());
  CHECK(std::isnan(sim.error()));
  CHECK_NOTHROW(run_steps(sim, 100));
}

TEST_CASE("a column higher than its box is refused, with the number of discs that fit", "[stage2]") {
  CHECK_NOTHROW(Simulation(stage2::stage().scene("stack"), typed({{"particles", 30.0}})));
  CHECK_THROWS_WITH(Simulation(stage2::stage().scene("stack"), typed({{"particles", 31.0}})),
                    "particles = 31 discs of radius 10 px do not fit: at most 30 do");
}
