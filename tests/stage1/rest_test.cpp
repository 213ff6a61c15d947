#include "common/laws/gravity.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/fused_model.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// Pushes up with `lift` from `lift_from` to `lift_to`.
struct Lift {
  static constexpr std::string_view name = "lift";
  double a, from_time, to_time;

  static Lift from(Parameters& p) {
    return {p.number({.name = "lift", .symbol = "", .unit = "L/s^2", .value = 15}),
            p.number({.name = "lift_from", .symbol = "", .unit = "s", .value = 1}),
            p.number({.name = "lift_to", .symbol = "", .unit = "s", .value = 1000})};
  }
  Vector body(const auto& /*p*/, Index /*i*/, double t) const {
    return {0, t >= from_time && t < to_time ? a : 0};
  }
};
static_assert(Law<Lift> && ActsOnBody<Lift>);

using LiftedModel = FusedModel<NoPairs, UniformMass, Gravity, Lift, CentreFloor>;

/// A particle at rest on the floor of `drop`, under its weight and a lift.
Scene lifted() {
  Scene scene = drop();
  scene.build = [](Parameters& p) {
    p.number(box_height);  // the fall from here sets the scale of speeds
    Setup setup{.particles = Particles(1, p.number(disc_mass)),
                .model = std::make_unique<LiftedModel>(p),
                .radius = p.number(disc_radius),
                .locate_impacts = true};
    setup.particles.position.row(0) << p.number(box_width) / 2, p.number(start_y);
    return setup;
  };
  scene.defaults = {{"radius", "0.05"}, {"height", "1.2"}, {"width", "1.5"}};
  return scene;
}

bool at_rest_on_floor(const Simulation& s) { return position(s).y == 0 && velocity(s) == Vector{0, 0}; }

void run_to_rest(Simulation& simulation, double until) {
  while (!at_rest_on_floor(simulation) && simulation.time() < until) simulation.step();
}

}  // namespace

TEST_CASE("infinitely many bounces end in the step that holds their limit, and the ball stays", "[stage1]") {
  const std::string integrator = GENERATE("velocity_verlet", "rk2", "rk4");
  const double dt = GENERATE(0.05, 0.01, 0.001);
  Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", dt}}), integrator);
  run_to_rest(simulation, 5);
  CAPTURE(integrator, dt, simulation.time());
  // These schemes follow the parabolas exactly; some sixty located impacts are each right to a few ulp.
  CHECK(simulation.time() >= 4.063712768872 - 1e-9);
  CHECK(simulation.time() - dt <= 4.063712768872 + 1e-9);
  run_steps(simulation, 1000);
  CHECK(at_rest_on_floor(simulation));
  CHECK(simulation.energy().dissipated == Approx(g).epsilon(1e-12));  // all of m g y0
  CHECK(simulation.model().folded == 0);
}

TEST_CASE("symplectic Euler finds the end of the bounces within an error of order 1", "[stage1]") {
  std::vector<double> off;
  for (const double dt : {4e-4, 2e-4, 1e-4}) {
    Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", dt}}), "symplectic_euler");
    run_to_rest(simulation, 6);
    off.push_back(std::abs(simulation.time() - 4.063712768872));
  }
  // A flight is g dt too slow at its end; 1/(1 - e) of them feel it, each e times less.
  CAPTURE(off[0], off[1], off[2]);
  CHECK(off[0] < 0.1);
  CHECK(slope({1, 2, 4}, off) == Approx(1).margin(0.25));
}

TEST_CASE("explicit Euler never lets the ball rest: it hops on with a speed that falls with dt", "[stage1]") {
  // A flight ends g dt faster than it began: v = e (v + g dt) holds for v = e g dt/(1 - e) = 4 g dt.
  const double dt = GENERATE(1e-3, 1e-4);
  Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", dt}}), "explicit_euler");
  run_to(simulation, 8);
  double fastest = 0;
  for (int step = 0; step < 100; ++step) {
    simulation.step();
    fastest = std::max(fastest, velocity(simulation).y);
  }
  CHECK(fastest == Approx(4 * g * dt).epsilon(0.3));  // the impact falls anywhere in its step
}

TEST_CASE("with drag the ball rests when the closed form says", "[stage1]") {
  Simulation simulation(drop(), typed({{"dt", 0.002}}), "rk4");
  run_to_rest(simulation, 5);
  CHECK(simulation.time() >= exact_ball().rest_time() - 1e-7);  // RK4 at 2 ms: 1e-10 per flight, over 1 - e
  CHECK(simulation.time() - 0.002 <= exact_ball().rest_time() + 1e-7);
  CHECK(simulation.energy().total() == Approx(g).epsilon(1e-9));
}

TEST_CASE("a particle at rest shows the acceleration of the laws alone", "[stage1]") {
  Simulation simulation(drop(), typed({{"dt", 0.01}}));
  run_to_rest(simulation, 5);
  REQUIRE(at_rest_on_floor(simulation));
  Vectors seen;
  simulation.look([&](const System& s) { seen = s.acceleration; });
  CHECK(row(seen, 0) == Vector{0, -g});
  simulation.step();
  CHECK(at_rest_on_floor(simulation));
}

TEST_CASE("a force that lifts a resting particle off the floor releases it", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const double dt = 0.001;
  Simulation simulation(lifted(), typed({{"dt", dt}}), scheme.name);
  run_to(simulation, 0.999);
  CHECK(at_rest_on_floor(simulation));
  run_to(simulation, 1.5);
  // Released within a step of t = 1 s: between the parabolas that start one step late and one early.
  const auto height = [&](double t) { return (15 - g) * t * t / 2; };
  CHECK(position(simulation).y >= height(0.5 - 2 * dt));
  CHECK(position(simulation).y <= height(0.5 + 2 * dt));
}

TEST_CASE("a force that is not strong enough leaves the particle on the floor", "[stage1]") {
  Simulation simulation(lifted(), typed({{"lift", 9.0}, {"dt", 0.01}}));
  run_to(simulation, 2);
  CHECK(at_rest_on_floor(simulation));
}

TEST_CASE("a jolt shorter than a step lifts the particle, which then falls back", "[stage1]") {
  // RK4 meets the jolt in the middle of one step only.
  Simulation simulation(
      lifted(), typed({{"lift", 30.0}, {"lift_from", 1.004}, {"lift_to", 1.006}, {"dt", 0.01}}), "rk4");
  run_to(simulation, 1.01);
  const double speed = velocity(simulation).y;
  CHECK(speed > 0);
  run_to(simulation,
         1.01 + 16 * speed / g);  // flights of 2 v/g, 1.6 v/g, ...: 10 v/g; it starts above the floor
  CHECK(at_rest_on_floor(simulation));
}

TEST_CASE("a particle that starts at rest on the floor stays there, without effort", "[stage1]") {
  const double e = GENERATE(0.0, 0.8, 1.0);
  const auto scheme = GENERATE(from_range(schemes()));
  Simulation simulation(drop(), typed({{"y0", 0.0}, {"restitution", e}}), scheme.name);
  run_steps(simulation, 100);
  CAPTURE(scheme.name, e);
  CHECK(at_rest_on_floor(simulation));
  CHECK(simulation.warnings().empty());
  CHECK(simulation.system().force_evaluations < 100 * 12);
}

TEST_CASE("hops too small for the time step keep their energy without loss", "[stage1]") {
  const std::string integrator = GENERATE("velocity_verlet", "rk2", "rk4");
  const double height = GENERATE(1e-5, 1e-7, 1e-9, 1e-12);
  // 3, 35, 350 and 11,000 flights per step of 10 ms; more than 64 are counted, not followed
  Simulation simulation(drop(), typed({{"y0", height}, {"restitution", 1.0}, {"drag", 0.0}, {"dt", 0.01}}),
                        integrator);
  const double energy = simulation.energy().mechanical();
  for (int step = 0; step < 200; ++step) {
    simulation.step();
    REQUIRE(position(simulation).y >= 0);
    // Each followed impact rounds the flight's share of the step to an ulp of dt: 1e-16 of 1e-6 s at worst.
    REQUIRE(simulation.energy().mechanical() == Approx(energy).epsilon(1e-6));
  }
}

TEST_CASE("a ball that loses little in each bounce fades away and rests on time", "[stage1]") {
  const double e = GENERATE(0.98, 0.99, 0.999, 0.9999);
  const BouncingBall ball{1e-6, 0, g, no_drag, e};
  const double dt = 0.005;
  Simulation simulation(drop(), typed({{"y0", 1e-6}, {"restitution", e}, {"drag", 0.0}, {"dt", dt}}));
  double before = simulation.energy().mechanical();
  CAPTURE(e, ball.rest_time());
  while (!at_rest_on_floor(simulation) && simulation.time() < 20) {
    simulation.step();
    const double now = simulation.energy().mechanical();
    REQUIRE(now <= before * (1 + 1e-9));
    before = now;
  }
  CHECK(simulation.time() >= ball.rest_time() * (1 - 1e-6));
  CHECK(simulation.time() - dt <= ball.rest_time() * (1 + 1e-6));
  CHECK(simulation.energy().dissipated == Approx(g * 1e-6).epsilon(1e-6));
}

TEST_CASE("a step with very many impacts costs no more than the impacts that are followed", "[stage1]") {
  const std::string integrator = GENERATE("velocity_verlet", "rk4");
  const double height = GENERATE(1e-6, 1e-9, 1e-15);
  Simulation simulation(drop(), typed({{"y0", height}, {"restitution", 1.0}, {"drag", 0.0}, {"dt", 0.05}}),
                        integrator);
  for (int step = 0; step < 20; ++step) {
    const long before = simulation.system().force_evaluations;
    simulation.step();
    // 64 impacts, each after a turning point: two searches, at worst bisections of a step down to its
    // 1e-16th, with at most four evaluations per trial. Followed one by one they would be 3e6.
    CHECK(simulation.system().force_evaluations - before < 64 * 2 * 60 * 4);
  }
}

TEST_CASE("a ball without restitution stops at its first impact", "[stage1]") {
  Simulation simulation(drop(), typed({{"restitution", 0.0}, {"drag", 0.0}, {"dt", 0.01}}));
  run_to(simulation, 0.46);  // the impact is at 0.4515 s
  CHECK(at_rest_on_floor(simulation));
  CHECK(simulation.energy().dissipated == Approx(g).epsilon(1e-12));
}
