#include <cmath>
#include <numbers>
#include <vector>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/tank_motion.hpp"
#include "common/references/waves.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using std::numbers::pi;

namespace {

constexpr double k = 2 * pi;  // of a wave as long as the tank, 1 m, on water as deep

struct Extreme {
  double time, height;
};

/// The first `count` extremes of the wave after the start, each the top of the parabola through three steps.
std::vector<Extreme> extremes(Simulation& wave, std::size_t count) {
  std::vector<Extreme> all;
  Extreme before{}, last{wave.time(), measure(wave, "wave_amplitude")};
  while (all.size() < count) {
    wave.step();
    const Extreme now{wave.time(), measure(wave, "wave_amplitude")};
    if (before.time > 0 && (last.height - before.height) * (now.height - last.height) < 0) {
      const double s = (last.height - before.height) / (last.time - before.time),
                   f = (now.height - last.height) / (now.time - last.time);
      const double top = (before.time + last.time) / 2 + s / (s - f) * (now.time - before.time) / 2;
      all.push_back({top, last.height});
    }
    before = last;
    last = now;
  }
  return all;
}

}  // namespace

TEST_CASE("a standing wave without viscosity swings with the frequency of linear theory within 1 %",
          "[stage5]") {
  Simulation wave(stage5::stage().scene("standing_wave"), {});
  const auto tops = extremes(wave, 3);  // at T/2, T, 3T/2
  CHECK(2 * pi / (tops[2].time - tops[0].time) == Approx(wave_frequency(9.81, k, 1)).epsilon(0.01));
}

TEST_CASE("a viscous standing wave swings and decays as Lamb's equation says, within 10 %", "[stage5]") {
  const double reynolds = GENERATE(100, 500);
  const double nu = std::sqrt(9.81) / reynolds;
  Simulation wave(stage5::stage().scene("standing_wave"), {{"nu", {to_text(nu)}}});
  // The start is at rest, which the decaying wave of the equation never is: it counts from the first half
  // swing on.
  const auto tops = extremes(wave, 3);
  const auto exact = viscous_wave(9.81, k, nu);
  const double period = tops[2].time - tops[0].time;
  CAPTURE(reynolds, period, tops[0].height, tops[2].height);
  CHECK(2 * pi / period == Approx(exact.frequency).epsilon(reynolds < 200 ? 0.02 : 0.01));
  // One swing over the one before, which does not see the few tenths of a millimetre by which the lattice
  // settles.
  const double half = (tops[1].height - tops[2].height) / (tops[1].height - tops[0].height);
  CHECK(-std::log(half) / (period / 2) == Approx(exact.decay).epsilon(0.1));
}

TEST_CASE("water in a tank that begins to move follows linear theory, the closer the finer it is",
          "[stage5]") {
  // Two natural periods. What is wrong comes from the smoothing of short waves, 0.15 (k h)^2 of their
  // frequency, and from the lattice's resistance to shear.
  const std::string scene = GENERATE("sloshing", "rolling");
  const auto worst = [&](double spacing) {
    Simulation tank(stage5::stage().scene(scene), typed({{"spacing", spacing}}));
    double most = 0;
    while (tank.time() < 2 * 1.18182) {
      tank.step();
      most = std::max(most, tank.error());
    }
    return most;
  };
  const double coarse = worst(0.025), fine = worst(0.0125);
  CAPTURE(scene, coarse, fine);
  CHECK(fine < 0.05);
  CHECK(fine < coarse);
  CHECK(coarse < 0.12);
}

TEST_CASE(
    "a square lattice of kernels resists a stretch with a share of its pressure, less where they are wider",
    "[stage5]") {
  // The energy of compression grows by p/rho times rho's growth, of which the second derivative is a modulus:
  // of an integral in place of the sum it would be 0.
  const auto modulus = [](double h_over_dx) {
    const WendlandC2 kernel(h_over_dx);
    const auto sum = [&](double stretch) {
      double all = 0;
      for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j)
          all += kernel.value(std::hypot(i * std::exp(stretch / 2), j * std::exp(-stretch / 2)));
      return all;
    };
    constexpr double small = 1e-3;
    return (sum(small) + sum(-small) - 2 * sum(0)) / (small * small * sum(0));
  };
  CHECK(modulus(2) == Approx(0.0094).epsilon(0.01));  // what the lesson says
  CHECK(modulus(2.5) == Approx(0.0046).epsilon(0.02));
  CHECK(modulus(3) == Approx(0.0024).epsilon(0.03));
}

TEST_CASE("what a moving tank puts into its water is in the budget of energy", "[stage5]") {
  const auto motion = GENERATE(Values{{"amplitude", 0.02}}, Values{{"amplitude", 0.0}, {"angle", 4.0}},
                               Values{{"amplitude", 0.01}, {"angle", 2.0}});
  auto values = motion;
  values.insert(values.end(), {{"spacing", 0.05}, {"h_over_dx", 2.0}});
  Simulation tank(stage5::stage().scene("sloshing"), typed(values));
  const double start = tank.energy().total(), calm = tank.energy().mechanical();
  double swing = 0;
  while (tank.time() < 1.5) {
    tank.step();
    swing = std::max(swing, std::abs(tank.energy().mechanical() - calm));
  }
  CAPTURE(swing);
  CHECK(swing > 0.1);
  CHECK(std::abs(tank.energy().total() - start) < 0.01 * swing);
}

TEST_CASE("a tank that is turned and stays so is a tank under turned gravity", "[stage5]") {
  // At theta = B with theta' = 0 the field is weight along (-sin B, -cos B), less the part that `Gravity`
  // has; with theta' it pushes away from the pivot, and turns what moves to its right.
  const double angle = 0.3, omega = 2;
  const TankMotion motion{.amplitude = 0, .angle = angle, .omega = omega, .middle = 0.5, .gravity = 9.81};
  const double quarter = pi / 2 / omega;  // theta = B, theta' = B W, theta'' = 0
  const double rate = angle * omega;
  const auto at_pivot = motion.field({0.5, 0}, quarter);
  CHECK(at_pivot.x == Approx(-9.81 * std::sin(angle)));
  CHECK(at_pivot.y == Approx(9.81 * (1 - std::cos(angle))));
  const auto beside = motion.field({0.9, 0.2}, quarter);
  CHECK(beside.x - at_pivot.x == Approx(rate * rate * 0.4));
  CHECK(beside.y - at_pivot.y == Approx(rate * rate * 0.2));
  Particles moving(1, 1);
  moving.velocity.row(0) << 1, 0;
  const auto coriolis = motion.body(view_of<UniformMass>(moving), 0, quarter);
  CHECK(coriolis.x == Approx(0).margin(1e-15));
  CHECK(coriolis.y == Approx(-2 * rate));
  // at the start nothing turns yet, and what is at rest feels theta'' alone, about the pivot
  const auto first = motion.field({0.5, 0.3}, 0);
  CHECK(first.x == Approx(angle * omega * omega * 0.3));
  CHECK(first.y == Approx(0).margin(1e-15));
}

TEST_CASE("a particle thrown in a tank that rolls and sways flies in a straight line, seen from outside",
          "[stage5]") {
  // No weight, no water: r' = X + R(theta) (r - P) is a straight line at constant speed. RK4 steps of 1 ms
  // leave 1e-12.
  const TankMotion motion{.amplitude = 0.2, .angle = 0.5, .omega = 3, .middle = 0.5, .gravity = 0};
  Particles one(1, 1);
  one.position.row(0) << 0.7, 0.4;
  one.velocity.row(0) << 0.3, -0.2;
  const auto rates = [&](const Vector& r, const Vector& v, double t) {
    one.position.row(0) << r.x, r.y;
    one.velocity.row(0) << v.x, v.y;
    return motion.field(r, t) + motion.body(view_of<UniformMass>(one), 0, t);
  };
  const auto outside = [&](const Vector& r, double t) {
    const double theta = 0.5 * (1 - std::cos(3 * t)), x = r.x - 0.5;
    return Vector{0.2 * (1 - std::cos(3 * t)) + std::cos(theta) * x - std::sin(theta) * r.y,
                  std::sin(theta) * x + std::cos(theta) * r.y};
  };
  Vector r{0.7, 0.4}, v{0.3, -0.2};
  const Vector start = outside(r, 0);
  constexpr double dt = 1e-3;
  for (int step = 0; step < 1000; ++step) {
    const double t = step * dt;
    const auto a1 = rates(r, v, t);
    const auto v2 = v + dt / 2 * a1, a2 = rates(r + dt / 2 * v, v2, t + dt / 2);
    const auto v3 = v + dt / 2 * a2, a3 = rates(r + dt / 2 * v2, v3, t + dt / 2);
    const auto v4 = v + dt * a3, a4 = rates(r + dt * v3, v4, t + dt);
    r += dt / 6 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += dt / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  const Vector end = outside(r, 1);
  CHECK(end.x - start.x == Approx(0.3).epsilon(1e-9));
  CHECK(end.y - start.y == Approx(-0.2).epsilon(1e-9));
}
