#include <cmath>

#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/brute_force.hpp"
#include "tests/common/discs.hpp"
#include "tests/common/momenta.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// A crowd of n discs, each in contact with three or four others, of masses between 0.1 and 10.
Discs crowd(Index n, std::uint64_t seed) {
  const double side = std::sqrt(static_cast<double>(n));
  Discs discs(random_points(n, {0, side, 0, side}, seed));
  discs.velocity = random_points(n, {-0.1, 0.1, -0.1, 0.1}, seed + 1);
  const Vectors exponents = random_points(n, {-1, 1, -1, 1}, seed + 2);
  for (Index i = 0; i < n; ++i) discs.mass(i) = std::pow(10, exponents(i, 0));
  return discs;
}

}  // namespace

TEST_CASE("a cloud without walls keeps its momentum and its angular momentum to round-off", "[stage2]") {
  const std::string integrator =
      GENERATE("explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4");
  Simulation sim(free_discs(crowd(200, 11)), {}, integrator);
  const auto start = momenta(sim.particles());
  run_steps(sim, 500);
  const auto end = momenta(sim.particles());
  CAPTURE(integrator);
  // 500 steps leave a round-off each in every particle; they add up as a walk at random, if that
  CHECK(norm(end.linear - start.linear) < 100 * epsilon * end.magnitude);
  // explicit Euler, RK2 and RK4 turn positions and velocities by different angles: angular momentum is theirs
  // to lose; the other two keep it, as all central kicks do
  if (integrator == "symplectic_euler" || integrator == "velocity_verlet")
    CHECK(std::abs(end.angular - start.angular) < 100 * epsilon * end.angular_magnitude);
}

TEST_CASE("the forces of a crowd add up to nothing, and so do their moments", "[stage2]") {
  const Discs discs = crowd(300, 5);
  const Vectors a = accelerations(discs);
  const double force = (a.colwise() * discs.mass).abs().sum();
  const Column fx = a.col(0) * discs.mass, fy = a.col(1) * discs.mass;
  CHECK(std::abs(fx.sum()) < 10 * epsilon * force);
  CHECK(std::abs(fy.sum()) < 10 * epsilon * force);
  const double moment = (discs.position.col(0) * fy - discs.position.col(1) * fx).sum();
  CHECK(std::abs(moment) < 10 * epsilon * force * 20);  // levers of up to 20
}

TEST_CASE("the forces between discs do not depend on where they are or how they are turned", "[stage2]") {
  const Discs discs = crowd(100, 3);
  const auto here = brute_force(discs);
  for (const double angle : {0.1, M_PI / 2, 2.0, -3.0}) {
    Discs moved = discs;
    moved.position = turned(discs.position, angle);
    moved.position.col(0) += 37.5;
    moved.position.col(1) -= 112.25;
    BruteForce expected = here;
    expected.acceleration = turned(here.acceleration, angle);
    CAPTURE(angle);
    CHECK(difference(accelerations(moved), expected) < 200 * 4 * epsilon);  // coordinates up to 120
  }
}

TEST_CASE("what a disc feels does not depend on the order in which the discs are listed", "[stage2]") {
  const Discs discs = crowd(100, 4);
  Discs reversed = discs;
  reversed.position = discs.position.colwise().reverse();
  reversed.mass = discs.mass.reverse();
  BruteForce expected = brute_force(discs);
  expected.acceleration = expected.acceleration.colwise().reverse().eval();
  expected.scale = expected.scale.reverse().eval();
  CHECK(difference(accelerations(reversed), expected) < 1e-14);
}

TEST_CASE("a scene gives the same in any units of length, mass and time", "[stage2]") {
  const Scene scene = stage2::stage().scene("cloud");
  const double L = 0x1p-7, M = 0x1p5, T = 0x1p3;  // powers of two, so that no digit is lost
  Simulation pixels(scene, typed({{"particles", 100.0}}));
  Simulation other(scene, typed({{"particles", 100.0},
                                 {"mass", M},
                                 {"radius", 10 * L},
                                 {"width", 800 * L},
                                 {"height", 600 * L},
                                 {"y0", 200 * L},
                                 {"gravity", 500 * L / (T * T)},
                                 {"drag", 0.1 * M / T},
                                 {"stiffness", 1.5e5 * M / (T * T)}}));
  CHECK(other.dt() == Approx(pixels.dt() * T).epsilon(4 * epsilon));
  pixels.set("dt", "0.0009765625");
  other.set("dt", "0.0078125");
  run_steps(pixels, 2000);
  run_steps(other, 2000);
  CHECK((other.particles().position == L * pixels.particles().position).all());
  CHECK((other.particles().velocity == L / T * pixels.particles().velocity).all());
  CHECK(other.energy().total() == M * L * L / (T * T) * pixels.energy().total());
}
