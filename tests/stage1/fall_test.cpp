#include "common/references/fall.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

constexpr double aloft = 0.4;  // [s], before the first impact

/// log2 of the ratio of the errors at n and 2n steps.
double order_between(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace

TEST_CASE("in free fall with drag each scheme converges with the order of its theory", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  // dt from 0.05 s to 0.0125 s: RK4 stays 1000 times above round-off, and the next term of the error, dt/tau
  // times the first, moves the observed order by 0.05 at most.
  const Values values{{"drag", 1.0}};
  const auto coarse = miss(scheme, values, exact_ball(), aloft, 8);
  const auto half = miss(scheme, values, exact_ball(), aloft, 16);
  const auto quarter = miss(scheme, values, exact_ball(), aloft, 32);
  CAPTURE(scheme.name, coarse.y, half.y, quarter.y, coarse.v, half.v, quarter.v);
  for (const auto& [one, two] : {std::pair{coarse, half}, std::pair{half, quarter}}) {
    CHECK(order_between(one.y, two.y) == Approx(scheme.order).margin(0.08));
    CHECK(order_between(one.v, two.v) == Approx(scheme.order).margin(0.08));
  }
}

TEST_CASE("a free fall without drag is a parabola, which order 2 follows exactly", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const long steps = GENERATE(10L, 100L, 1000L);
  const auto end = miss(scheme, {{"drag", 0.0}}, exact_ball(no_drag), aloft, steps);
  CAPTURE(scheme.name, steps, end.y, end.v);
  // Each step rounds y (at most 1) and v (at most 4) once or twice.
  const double rounding = 8 * epsilon * static_cast<double>(steps);
  CHECK(end.v <= rounding);
  if (scheme.order >= 2)
    CHECK(end.y <= rounding);
  else  // one Euler takes the speed of the step's start, the other that of its end: both miss by g t dt/2
    CHECK(end.y == Approx(g * aloft * aloft / 2 / static_cast<double>(steps)).epsilon(1e-9));
}

TEST_CASE("a ball thrown up obliquely follows the closed form of both coordinates", "[stage1]") {
  // RK4 at dt = 5 ms: (dt/tau)^4/120 of g tau t = 1.5 m/s each second, 1e-10 in all.
  Simulation simulation(drop(), typed({{"vx0", 0.5}, {"vy0", 2.0}, {"y0", 0.5}, {"drag", 2.0}}, 0.3, 60),
                        "rk4");
  run_to(simulation, 0.3);
  const Fall fall{.height = 0.5, .speed = 2, .gravity = g, .drag_time = 0.5};
  CHECK(position(simulation).y == Approx(fall.at(0.3).y).epsilon(1e-9));
  CHECK(position(simulation).x == Approx(0.75 + 0.5 * 0.5 * -std::expm1(-0.3 / 0.5)).epsilon(1e-9));
  CHECK(velocity(simulation).x == Approx(0.5 * std::exp(-0.3 / 0.5)).epsilon(1e-9));
}

TEST_CASE("the same motion in pixels and in metres is the same motion", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const std::string impacts = GENERATE("located", "clamp");
  Scene in_pixels = drop();
  in_pixels.length_unit = "px";
  const auto lengths = [&](double unit) {
    return typed({{"radius", 0.05 * unit},
                  {"gravity", g * unit},
                  {"width", 1.5 * unit},
                  {"height", 1.2 * unit},
                  {"x0", 0.75 * unit},
                  {"y0", unit},
                  {"vx0", 2 * unit},
                  {"impacts", impacts}});
  };
  Simulation metres(drop(), lengths(1), scheme.name), pixels(in_pixels, lengths(1000), scheme.name);
  CHECK(pixels.dt() == Approx(metres.dt()).epsilon(4 * epsilon));
  run_to(metres, 2);
  run_to(pixels, 2);
  // The factor 1000 rounds differently in each of some 2,000 steps; the floor turns speeds but keeps errors.
  const double far = 1e-11;
  CHECK(position(pixels).x / 1000 == Approx(position(metres).x).margin(far));
  CHECK(position(pixels).y / 1000 == Approx(position(metres).y).margin(far));
  CHECK(velocity(pixels).x / 1000 == Approx(velocity(metres).x).margin(far));
  CHECK(velocity(pixels).y / 1000 == Approx(velocity(metres).y).margin(far));
  CHECK(pixels.energy().total() / 1e6 == Approx(metres.energy().total()).epsilon(far));
}
