#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/references/spring_pair.hpp"
#include "stage2_cloud/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/common/discs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

constexpr double speed = 200, radius = 10, stiffness = 1.5e5;  // of scene pair
constexpr double centre = 400;

/// A head-on collision that begins `gap` before contact, with steps of `w_dt` of the contact's frequency.
struct Collision {
  double w, dt;
  Simulation sim;

  Collision(std::string_view integrator, double w_dt, double gap, double mass_ratio = 1)
      : w(std::sqrt(stiffness * (1 + 1 / mass_ratio))),
        dt(w_dt / w),
        sim(stage2::stage().scene("pair"),
            typed({{"dt", dt}, {"x0", centre - radius - gap / 2}, {"mass_ratio", mass_ratio}}), integrator) {}

  [[nodiscard]] double distance() const {
    return sim.particles().position(1, 0) - sim.particles().position(0, 0);
  }
  [[nodiscard]] double closing() const {
    return sim.particles().velocity(0, 0) - sim.particles().velocity(1, 0);
  }
};

/// What single contacts do, each met at another moment of the time step.
struct Contacts {
  double restitution = 0;  ///< mean of speed after over speed before
  double duration = 0;     ///< mean time in contact [s]
  double momentum = 0;     ///< largest change of sum m v over sum m |v|
};

Contacts contacts(std::string_view integrator, double w_dt, int phases, double mass_ratio = 1) {
  Contacts mean;
  for (int phase = 0; phase < phases; ++phase) {
    const double step = 2 * speed * w_dt / std::sqrt(stiffness * (1 + 1 / mass_ratio));
    Collision c(integrator, w_dt, (phase + 0.5) / phases * step, mass_ratio);
    const double before = momentum(c.sim.particles()).x;
    long in_contact = 0;
    do {
      c.sim.step();
      in_contact += c.distance() < 2 * radius ? 1 : 0;
    } while (c.distance() < 2 * radius || c.closing() > 0);
    mean.restitution += -c.closing() / (2 * speed) / phases;
    mean.duration += static_cast<double>(in_contact) * c.dt / phases;
    mean.momentum = std::max(mean.momentum,
                             std::abs(momentum(c.sim.particles()).x - before) / (speed * (1 + mass_ratio)));
  }
  return mean;
}

/// Root mean square, over 64 moments of the step at which contact may begin, of the error at the time `t`.
double error_at(double t, std::string_view integrator, double w_dt) {
  constexpr int phases = 64;
  const double step = 2 * speed * w_dt / std::sqrt(2 * stiffness);
  double sum = 0;
  for (int phase = 0; phase < phases; ++phase) {
    Collision c(integrator, w_dt, 4 + (phase + 0.5) / phases * step);
    run_to(c.sim, t);
    sum += c.sim.error() * c.sim.error();
  }
  return std::sqrt(sum / phases);
}

/// Powers of dt that the error at time t falls by, on average over four halvings.
double order_at(double t, std::string_view integrator) {
  return std::log2(error_at(t, integrator, 0.1) / error_at(t, integrator, 0.00625)) / 4;
}

}  // namespace

TEST_CASE("two discs that collide head-on part, on average, with the speed they met at", "[stage2]") {
  const std::string integrator = GENERATE("symplectic_euler", "velocity_verlet");
  for (const double w_dt : {0.5, 0.2, 0.1, 0.05, 0.025}) {
    CAPTURE(integrator, w_dt);
    // What a whole number of steps makes of half a period cancels over the phases up to order 4.
    CHECK(std::abs(contacts(integrator, w_dt, 400).restitution - 1) < 0.01 * std::pow(w_dt, 4));
  }
  CHECK(std::abs(contacts(integrator, 0.1, 400).restitution - 1) < 7.5e-7);
}

TEST_CASE("explicit Euler throws colliding discs apart by (1 + w^2 dt^2) of energy per step in contact",
          "[stage2]") {
  const std::vector<std::pair<double, double>> published{
      {0.5, 2.13}, {0.2, 1.366}, {0.1, 1.170}, {0.05, 1.082}, {0.025, 1.040}};
  for (const auto& [w_dt, restitution] : published) {
    const double measured = contacts("explicit_euler", w_dt, 400).restitution;
    CAPTURE(w_dt, measured);
    CHECK(std::abs(measured - restitution) < 1e-3);  // half of the last printed digit, or so
    // a contact lasts a whole number of steps, half of one longer or shorter than half a period
    CHECK(measured == Approx(explicit_euler_restitution(w_dt)).epsilon(w_dt * w_dt / 2));
  }
}

TEST_CASE("a contact lasts half a period of its spring, pi sqrt(mu/k)", "[stage2]") {
  const double mass_ratio = GENERATE(1e-3, 0.5, 1.0, 3.0, 1e3, 1e6);
  const double mu = mass_ratio / (1 + mass_ratio);
  const double exact = std::numbers::pi * std::sqrt(mu / stiffness);
  for (const double w_dt : {0.2, 0.05}) {
    CAPTURE(mass_ratio, w_dt);
    // Verlet's frequency is (w dt)^2/24 too high; 400 phases count the steps to 1/400 of one
    CHECK(contacts("velocity_verlet", w_dt, 400, mass_ratio).duration ==
          Approx(exact).epsilon(w_dt * w_dt / 20 + w_dt / 400));
  }
}

TEST_CASE("discs of very different mass part with the speed they met at and keep their momentum",
          "[stage2]") {
  const double mass_ratio = GENERATE(1e-3, 1e-2, 0.5, 3.0, 1e3, 1e6);
  const std::string integrator = GENERATE("symplectic_euler", "velocity_verlet");
  const auto seen = contacts(integrator, 0.1, 200, mass_ratio);
  CAPTURE(mass_ratio, integrator);
  CHECK(std::abs(seen.restitution - 1) < 7.5e-7);  // only mu counts, so the same for all ratios
  CHECK(seen.momentum < 100 * epsilon);            // some 40 steps, each with a round-off or two
}

TEST_CASE("each integrator follows a collision with its order, at most that of the corner in the force",
          "[stage2]") {
  // The force has a corner where contact begins: no scheme passes it with more than order 2.
  const std::vector<std::pair<std::string, double>> orders{{"explicit_euler", 1.0},
                                                           {"symplectic_euler", 2.0},
                                                           {"velocity_verlet", 2.0},
                                                           {"rk2", 2.0},
                                                           {"rk4", 2.0}};
  for (const auto& [integrator, order] : orders) {
    CAPTURE(integrator);
    CHECK(order_at(0.03, integrator) == Approx(order).margin(0.15));  // contact is from 0.010 to 0.016 s
  }
}

TEST_CASE("symplectic Euler moves colliding discs as Verlet does, only its velocities are half a step old",
          "[stage2]") {
  Collision euler("symplectic_euler", 0.1, 4), verlet("velocity_verlet", 0.1, 4);
  double furthest = 0, latest = 0;
  for (int step = 0; step < 120; ++step) {
    euler.sim.step();
    verlet.sim.step();
    const auto &e = euler.sim.particles(), &v = verlet.sim.particles();
    furthest = std::max(furthest, (e.position - v.position).abs().maxCoeff());
    latest = std::max(latest, (e.velocity + euler.dt / 2 * v.acceleration - v.velocity).abs().maxCoeff());
  }
  CHECK(furthest < 1000 * centre * epsilon);     // 120 steps of round-off at x = 400
  CHECK(latest < 1000 * speed * epsilon * 100);  // the force magnifies that by k/m dt = 30 per step
}

TEST_CASE("scene pair follows its closed form until a disc reaches a wall", "[stage2]") {
  const std::string dt = GENERATE("auto", "1e-4");
  Simulation sim(stage2::stage().scene("pair"), {{"dt", {dt}}});
  CHECK(sim.binding_limit().name == "contact");
  const double w_dt = sim.dt() * std::sqrt(2 * stiffness);
  double worst = 0;
  while (sim.time() < 2.8) {  // they touch at 0.95 s and reach the walls at 2.86 s
    sim.step();
    worst = std::max(worst, sim.error());
  }
  // a step over a corner of the force misses up to (w dt)^2/8 of the speed; two of them, and 370 px of flight
  CHECK(worst < 370 * w_dt * w_dt / 4);
  CHECK(worst > 0);
  run_to(sim, 3);
  CHECK(std::isnan(sim.error()));  // the closed form knows no walls
}

TEST_CASE("energy of scene pair is what it was, once the discs and the walls have let go", "[stage2]") {
  Simulation sim(stage2::stage().scene("pair"), typed({{"dt", 1e-5}}));
  const double start = sim.energy().total();
  run_to(sim, 5);  // two collisions with each other, at the walls in between
  CHECK(sim.energy().elastic == 0);
  // each contact leaves up to (w dt)^2 = 3e-5 of the energy, with the phase it is met at
  CHECK(sim.energy().total() == Approx(start).epsilon(1e-4));
}
