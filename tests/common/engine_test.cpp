#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "common/laws/air_drag.hpp"
#include "common/laws/gravity.hpp"
#include "common/laws/walls.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/fused_model.hpp"
#include "common/simulation/quantities.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

/// A law as a student writes it: the wind carries along what the air holds, f = beta w e_x.
struct Wind {
  static constexpr std::string_view name = "wind";
  double w, beta;

  static Wind from(Parameters& p) {
    return {p.number({.name = "wind", .symbol = "w", .unit = "L/s", .value = 3}), AirDrag::from(p).beta};
  }
  Vector body(const auto& p, Index i, double /*t*/) const { return {beta * w / p.mass(i), 0}; }
  double dissipation(const auto& p, Index i, double /*t*/) const { return -beta * w * p.velocity(i).x; }  // it gives
};
static_assert(Law<Wind> && ActsOnBody<Wind> && Dissipates<Wind>);

/// One particle, starting at rest in the middle of a wide box 100 m high, under `Laws`.
template <Law... Laws>
Scene outdoors() {
  return {
      .name = "outdoors",
      .length_unit = "m",
      .defaults = {{"radius", "0.05"}, {"width", "1000"}, {"height", "100"}, {"mass", "2"}, {"drag", "4"}},
      .build = [](Parameters& p) {
        Setup setup{.particles = Particles(1, p.number(disc_mass)),
                    .model = std::make_unique<FusedModel<NoPairs, UniformMass, Laws...>>(p),
                    .radius = p.number(disc_radius),
                    .locate_impacts = true};
        setup.particles.position.row(0) << p.number(box_width) / 2, p.number(box_height) / 2;
        return setup;
      }};
}

Overrides small_cloud() { return typed({{"particles", 300.0}, {"vx0", 300.0}, {"y0", 0.0}}); }

const Scene& cloud() {
  static const Stage stage = stage3::stage();
  return stage.scene("cloud");
}

/// Everything that only reads a simulation.
void look_at_everything(Simulation& simulation) {
  simulation.look([](const System&) {});
  static_cast<void>(simulation.energy());
  static_cast<void>(simulation.error());
  static_cast<void>(simulation.warnings());
  static_cast<void>(simulation.bytes_per_particle());
  static_cast<void>(simulation.model().neighbourhood(simulation.particles(), 0));
  static_cast<void>(simulation.model().count_pairs(simulation.particles()));
  static_cast<void>(simulation.model().law_seconds(simulation.system(), 3));
}

}  // namespace

TEST_CASE("a law of ten lines joins the scene with its parameter, its cost and its energy", "[engine]") {
  Simulation simulation(outdoors<Gravity, AirDrag, Wind, BoxWalls>(), typed({{"dt", 0.01}}), "rk4");
  const auto* wind = simulation.parameters().find("wind");
  REQUIRE(wind != nullptr);
  CHECK((wind->value == 3 && wind->unit == "m/s" && wind->change == Change::live));
  CHECK(simulation.model().laws() == std::vector<std::string>{"gravity", "air_drag", "wind", "walls"});
  CHECK(simulation.model().law_seconds(simulation.system(), 5).size() == 4);

  const double energy = simulation.energy().total(), tau = 0.5, t = 2;
  run_to(simulation, t);
  // v' = (w - v)/tau; RK4 at dt/tau = 0.02 misses by 1e-9 of it.
  const double v = 3 * -std::expm1(-t / tau);
  CHECK(velocity(simulation).x == Approx(v).epsilon(1e-8));
  CHECK(position(simulation).x == Approx(500 + 3 * t - tau * v).epsilon(1e-9));
  CHECK(simulation.energy().total() == Approx(energy).epsilon(1e-9));

  simulation.set("wind", "0");
  run_to(simulation, t + 1);
  CHECK(velocity(simulation).x == Approx(v * std::exp(-1 / tau)).epsilon(1e-8));
}

TEST_CASE("without weight and at rest, a law of one's own may set a particle going", "[engine]") {
  // No fall sets a scale of speeds there: what is fast is then nobody's guess.
  Simulation simulation(outdoors<AirDrag, Wind, BoxWalls>(), typed({{"dt", 0.01}}), "rk4");
  run_to(simulation, 2);
  CHECK(velocity(simulation).x == Approx(3 * -std::expm1(-2 / 0.5)).epsilon(1e-8));
}

TEST_CASE("a scene pays only for what its laws name", "[engine]") {
  Simulation one(drop());
  one.step();
  CHECK(one.bytes_per_particle() == 6 * sizeof(double));  // r, v, a
  CHECK(one.particles().extra.empty());
  CHECK_FALSE(one.model().has_pairs());
  CHECK_FALSE(one.model().neighbourhood(one.particles(), 0));
  CHECK(one.model().count_pairs(one.particles()).candidates == 0);

  const auto stage = stage2::stage();
  const double n = 300;
  Simulation all_pairs(stage.scene("cloud"), small_cloud());
  all_pairs.step();
  // Besides r, v, a: x and y in the order of the sweep, and one pack of padding. No velocity: no law reads
  // it.
  CHECK(all_pairs.bytes_per_particle() == Approx(8 * (6 + 2 * (1 + static_cast<double>(pack_width) / n))));
  CHECK(all_pairs.particles().extra.empty());
  Simulation of_two(stage.scene("pair"));
  CHECK(of_two.particles().extra.size() == 1);  // their masses differ
  CHECK(of_two.particles().extra.front().name == "mass");
}

TEST_CASE("the same run twice is the same, bit for bit, on any number of threads", "[engine]") {
  const auto scheme = GENERATE(from_range(schemes()));
  Simulation one(drop(), {}, scheme.name), other(drop(), {}, scheme.name);
  run_steps(one, 3000);
  run_steps(other, 3000);
  CHECK(same_state(one, other));

  Simulation alone(cloud(), small_cloud(), scheme.name), shared(cloud(), small_cloud(), scheme.name, 3);
  run_steps(alone, 100);
  run_steps(shared, 100);
  CHECK(same_state(alone, shared));
}

TEST_CASE("looking never changes what is looked at", "[engine]") {
  const auto scheme = GENERATE(from_range(schemes()));
  for (const auto* scene : {&drop(), &bounce(), &cloud()}) {
    const auto overrides = scene == &cloud() ? small_cloud() : Overrides{};
    Simulation watched(*scene, overrides, scheme.name), alone(*scene, overrides, scheme.name);
    for (int step = 0; step < 60; ++step) {
      watched.step();
      look_at_everything(watched);
    }
    run_steps(alone, 60);
    CAPTURE(scene->name, scheme.name);
    CHECK(same_state(watched, alone));
    CHECK(watched.warnings() == alone.warnings());
  }
}

TEST_CASE("a look sees the acceleration that belongs to the state as it stands", "[engine]") {
  const auto scheme = GENERATE(from_range(schemes()));
  Simulation simulation(drop(), typed({{"dt", 0.01}, {"drag", 2.0}}), scheme.name);
  run_steps(simulation, 30);
  simulation.look([&](const System& s) {
    CHECK(s.acceleration(0, 1) == Approx(-g - 2 * s.velocity(0, 1)).epsilon(4 * epsilon));
    CHECK(s.dissipation == Approx(2 * s.velocity(0, 1) * s.velocity(0, 1)).epsilon(4 * epsilon));
  });
}

TEST_CASE("a look is neither timed nor counted", "[engine]") {
  const auto stage = stage2::stage();
  // both discs at one point: 400 px is the middle
  Simulation simulation(stage.scene("pair"), typed({{"x0", 400.0}, {"vx0", 0.0}, {"dt", 1e-4}}));
  simulation.step();
  const auto warnings = simulation.warnings();
  const auto counted = simulation.model().coincident;
  CHECK(counted == 1);
  for (int k = 0; k < 10; ++k) look_at_everything(simulation);
  CHECK(simulation.warnings() == warnings);
  CHECK(simulation.model().coincident == counted);
  CHECK(simulation.model().seconds.forces == 0);
  CHECK(simulation.model().seconds.neighbours == 0);
}

TEST_CASE("another integrator may take over at any instant", "[engine]") {
  Simulation simulation(drop(), typed({{"drag", 0.0}, {"dt", 0.01}}), "rk4");
  run_steps(simulation, 13);
  for (const auto* name : {"velocity_verlet", "rk2", "rk4"}) {
    simulation.use_integrator(name);
    run_steps(simulation, 80);
  }
  // The three follow the parabolas exactly, and locate their impacts.
  CHECK(position(simulation).y == Approx(exact_ball(no_drag).at(simulation.time()).y).epsilon(1e-11));
  CHECK_THROWS_AS(simulation.use_integrator("leapfrog"), BadInput);
  CHECK(simulation.integrator() == "rk4");
}
