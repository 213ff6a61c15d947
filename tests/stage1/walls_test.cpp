#include <random>

#include "common/laws/walls.hpp"
#include "common/simulation/errors.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Reflections one by one between two walls.
Folded bounce_between(double r, double v, double dt, double low, double high, double e) {
  double impacts = 0;
  while (v != 0) {
    const double flight = ((v > 0 ? high : low) - r) / v;
    if (!(flight < dt)) break;
    r = v > 0 ? high : low;
    v *= -e;
    dt -= flight;
    ++impacts;
  }
  return {r + v * dt, v, impacts};
}

/// Hops one by one on a wall.
Folded hop_by_hop(double v, double a, double dt, double e) {
  double hops = 0;
  while (2 * v / a < dt && v > 1e-14) {
    dt -= 2 * v / a;
    v *= e;
    ++hops;
  }
  return {dt * (v - a * dt / 2), v - a * dt, hops};
}

/// Numbers that are the same on every machine.
class Chance {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  /// Evenly spread over the powers of ten.
  double any_size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

 private:
  std::mt19937_64 bits_{2024};
};

/// In the window of 800 x 600 px with discs of 10 px: centres between 10 and 790, 10 and 590.
Values weightless(const std::string& impacts, double e) {
  return {{"gravity", 0.0}, {"drag", 0.0}, {"restitution", e}, {"impacts", impacts}};
}

Values start(Values values, Vector r, Vector v, double dt) {
  values.insert(values.end(), {{"x0", r.x}, {"y0", r.y}, {"vx0", v.x}, {"vy0", v.y}, {"dt", dt}});
  return values;
}

}  // namespace

TEST_CASE("reflections counted in closed form are those of a ball followed from wall to wall", "[stage1]") {
  const double e = GENERATE(0.0, 0.3, 0.8, 0.99, 1.0);
  Chance chance;
  for (int trial = 0; trial < 2000; ++trial) {
    const double low = chance.between(-5, 5), length = chance.any_size(0.01, 100), high = low + length;
    const double r = chance.between(low, high), dt = chance.any_size(1e-3, 10);
    const double v = (trial % 2 == 0 ? 1 : -1) * chance.any_size(1e-2, 2000) * length / dt;
    const auto folded = fold(r, v, dt, low, high, e);
    const auto followed = bounce_between(r, v, dt, low, high, e);
    CAPTURE(e, low, high, r, v, dt, folded.impacts, followed.impacts);
    // Followed, up to 2000 flights round to an ulp of their end each.
    const double rounding = 1e-10 * (length + std::abs(low));
    REQUIRE(folded.position >= low);
    REQUIRE(folded.position <= high);
    REQUIRE(std::abs(folded.position - followed.position) <= rounding);
    const bool just_at_a_wall = std::min(followed.position - low, high - followed.position) <= rounding;
    if (just_at_a_wall && folded.impacts != followed.impacts) continue;  // before or after: round-off decides
    REQUIRE(folded.impacts == followed.impacts);
    REQUIRE(folded.velocity == Approx(followed.velocity).epsilon(1e-12).margin(0));
  }
}

TEST_CASE("a ball that reaches no wall flies straight through its closed form", "[stage1]") {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto up = fold(1, 2, 3, 0, infinite, 0.8), resting = fold(1, 0, 3, 0, 5, 0.8);
  CHECK((up.position == 7 && up.velocity == 2 && up.impacts == 0));
  CHECK((resting.position == 1 && resting.velocity == 0 && resting.impacts == 0));
  const auto bounced = fold(1, -2, 3, 0, infinite, 0.5);  // half a second down, then up at half the speed
  CHECK((bounced.position == 2.5 && bounced.velocity == 1 && bounced.impacts == 1));
}

TEST_CASE("hops counted in closed form are those of a ball followed hop by hop", "[stage1]") {
  const double e = GENERATE(0.0, 0.5, 0.9, 0.999, 1.0);
  Chance chance;
  for (int trial = 0; trial < 1000; ++trial) {
    const double a = chance.any_size(0.1, 1000), v = chance.any_size(1e-3, 1);
    const double dt = chance.any_size(0.1, 500) * 2 * v / a;
    const auto counted = hop(v, a, dt, e);
    CAPTURE(e, a, v, dt, counted.impacts);
    REQUIRE(counted.position >= 0);
    if (dt >= 2 * v / (a * (1 - e))) {  // all of them are over
      REQUIRE((counted.position == 0 && counted.velocity == 0));
      continue;
    }
    const auto followed = hop_by_hop(v, a, dt, e);
    // Five hundred flights, each rounded to an ulp of dt: times the speed, times the acceleration.
    REQUIRE(std::abs(counted.position - followed.position) <= 1e-12 * v * dt);
    if (counted.impacts == followed.impacts)  // at an impact, round-off decides which side of it
      REQUIRE(std::abs(counted.velocity - followed.velocity) <= 1e-12 * a * dt);
    else
      REQUIRE(counted.position <= 1e-12 * v * dt);
  }
}

TEST_CASE("a particle that flies into a corner is turned round by both walls once", "[stage1]") {
  const std::string impacts = GENERATE("located", "clamp");
  const auto scheme = GENERATE(from_range(schemes()));
  const Vector side = GENERATE(Vector{1, 1}, Vector{-1, 1}, Vector{1, -1}, Vector{-1, -1});
  // 100 px from the corner in both directions, at 200 px/s in both: there after half a second.
  const Vector corner{400 + side.x * 390, 300 + side.y * 290};
  Simulation simulation(bounce(),
                        typed(start(weightless(impacts, 0.8), corner - 100.0 * side, 200.0 * side, 0.2)),
                        scheme.name);
  run_steps(simulation, 3);
  CAPTURE(impacts, scheme.name, side.x, side.y);
  // Explicit Euler included: without forces every scheme flies straight. Coordinates round to 1e-13 px.
  CHECK(velocity(simulation).x == Approx(-160 * side.x).epsilon(1e-12));
  CHECK(velocity(simulation).y == Approx(-160 * side.y).epsilon(1e-12));
  const double beyond = impacts == "located" ? 0.1 * 160 : 0;  // clamped, it starts anew from the corner
  CHECK(position(simulation).x == Approx(corner.x - side.x * beyond).margin(1e-9));
  CHECK(position(simulation).y == Approx(corner.y - side.y * beyond).margin(1e-9));
  CHECK(simulation.energy().dissipated == Approx(2 * 200 * 200 / 2 * (1 - 0.64)).epsilon(1e-12));
}

TEST_CASE("a mirrored set-up gives the mirrored motion", "[stage1]") {
  const std::string impacts = GENERATE("located", "clamp");
  auto values = weightless(impacts, 0.9);
  values[1].second = 0.3;  // drag
  Simulation right(bounce(), typed(start(values, {500, 320}, {911, 677}, 0.013)));
  Simulation left(bounce(), typed(start(values, {300, 320}, {-911, 677}, 0.013)));
  for (int step = 0; step < 500; ++step) {
    right.step();
    left.step();
    // The two sides of the box round differently, some 1e-13 px in each of 500 steps.
    REQUIRE(position(left).x == Approx(800 - position(right).x).margin(1e-9));
    REQUIRE(velocity(left).x == Approx(-velocity(right).x).margin(1e-9));
    REQUIRE(position(left).y == Approx(position(right).y).margin(1e-9));
  }
}

TEST_CASE("a particle a thousand boxes fast stays inside, with the right parity, and the run says so",
          "[stage1]") {
  const std::string impacts = GENERATE("located", "clamp");
  const std::string integrator = GENERATE("velocity_verlet", "explicit_euler", "rk4");
  const double boxes = GENERATE(1000.23, 999.77, 1000.77, -1000.23);
  const double dt = 0.01;
  const Vector r{400, 300}, v{boxes * 780 / dt, -boxes * 580 / dt};
  Simulation simulation(bounce(), typed(start(weightless(impacts, 1), r, v, dt)), integrator);
  for (int step = 1; step <= 5; ++step) {
    simulation.step();
    const auto x = bounce_between(r.x, v.x, step * dt, 10, 790, 1),
               y = bounce_between(r.y, v.y, step * dt, 10, 590, 1);
    CAPTURE(impacts, integrator, boxes, step);
    // A way of 4e6 px is known to 1e-9 px.
    CHECK(position(simulation).x == Approx(x.position).margin(1e-6));
    CHECK(position(simulation).y == Approx(y.position).margin(1e-6));
    CHECK(velocity(simulation).x == Approx(x.velocity).epsilon(1e-12));
    CHECK(velocity(simulation).y == Approx(y.velocity).epsilon(1e-12));
  }
  CHECK_THAT(simulation.warnings().back(), ContainsSubstring("more often in one step than is followed"));
}

TEST_CASE("a fast particle that loses little in each reflection ends where following it would end",
          "[stage1]") {
  const std::string impacts = GENERATE("located", "clamp");
  const double e = GENERATE(0.0, 0.5, 0.99, 0.999);
  const Vector r{400, 300}, v{1000.25 * 780 / 0.01, 0};
  Simulation simulation(bounce(), typed(start(weightless(impacts, e), r, v, 0.01)));
  simulation.step();
  const auto x = bounce_between(r.x, v.x, 0.01, 10, 790, e);
  CHECK(position(simulation).x == Approx(x.position).margin(1e-6));
  CHECK(velocity(simulation).x == Approx(x.velocity).epsilon(1e-9));
  CHECK(simulation.energy().total() == Approx(v.x * v.x / 2).epsilon(1e-12));
}

TEST_CASE("weight still acts on a particle whose sideways reflections are counted", "[stage1]") {
  auto values = start(weightless("located", 1), {400, 300}, {1000.25 * 780 / 0.01, 100}, 0.01);
  values[0].second = 500.0;  // gravity
  Simulation simulation(bounce(), typed(values));
  simulation.step();
  CHECK(position(simulation).y == Approx(300 + 100 * 0.01 - 500 * 0.01 * 0.01 / 2).epsilon(1e-12));
  CHECK(velocity(simulation).y == Approx(100 - 500 * 0.01).epsilon(1e-12));
}

TEST_CASE("without weight a particle flies straight between the walls for ever", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  Simulation simulation(bounce(), typed(start(weightless("located", 1), {100, 500}, {330, -270}, 0.01)),
                        scheme.name);
  run_to(simulation, 50);
  const auto x = bounce_between(100, 330, 50, 10, 790, 1), y = bounce_between(500, -270, 50, 10, 590, 1);
  CHECK(position(simulation).x == Approx(x.position).margin(1e-8));  // 5000 steps of 1e-13 px each
  CHECK(position(simulation).y == Approx(y.position).margin(1e-8));
}
