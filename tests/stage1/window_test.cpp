#include "common/simulation/errors.hpp"
#include "tests/catch.hpp"
#include "tests/stage1/drop.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("the rim of the disc stays inside a window of any size, and the disc ends on its floor",
          "[stage1]") {
  const auto [width, height] = GENERATE(
      table<double, double>({{800, 600}, {60, 600}, {800, 40}, {20.5, 4000}, {4000, 20.5}, {1e5, 1e5}}));
  const std::string impacts = GENERATE("located", "clamp");
  Simulation simulation(bounce(), typed({{"width", width},
                                         {"height", height},
                                         {"x0", width / 2},
                                         {"y0", height / 2},
                                         {"vx0", 170.0},
                                         {"drag", 0.5},
                                         {"dt", 0.01},
                                         {"impacts", impacts}}));
  CAPTURE(width, height, impacts);
  while (simulation.time() < 60) {
    simulation.step();
    const auto r = position(simulation);
    REQUIRE((r.x >= 10 && r.x <= width - 10 && r.y >= 10 && r.y <= height - 10));
  }
  if (impacts == "located")
    CHECK(position(simulation).y == 10);
  else  // clamped, it gains up to g dt in each hop and goes on with v = e g dt/(1 - e), v^2/(2 g) high
    CHECK(position(simulation).y <= 10 + 8 * 500 * 0.01 * 0.01);
}

TEST_CASE("a window narrower than the disc, or just as wide, is refused before anything runs", "[stage1]") {
  const double side = GENERATE(19.0, 20.0);
  const std::string which = GENERATE("width", "height");
  CHECK_THROWS_WITH(
      Simulation(bounce(), typed({{which, side}})),
      ContainsSubstring("radius = 10 px is too large") && ContainsSubstring("wider than 2 radius"));
}

TEST_CASE("a start outside the walls is refused with the place that would do", "[stage1]") {
  CHECK_THROWS_WITH(Simulation(bounce(), typed({{"x0", 5.0}})),
                    ContainsSubstring("x0 = 5 px") && ContainsSubstring("between 10 and 790 px"));
  CHECK_THROWS_WITH(Simulation(drop(), typed({{"y0", -0.1}})), ContainsSubstring("y0 = -0.1 m"));
}

TEST_CASE("a turn just short of the ceiling changes nothing", "[stage1]") {
  // Thrown from 100 px at 400 px/s, the disc turns 160 px higher without drag. The ceiling comes so near that
  // the step looks for an impact there, in vain.
  const auto scheme = GENERATE(from_range(schemes()));
  const double speed = GENERATE(400.0, 401.0, 402.0, 403.0, 404.0);
  const auto thrown = [&](double height) {
    return typed({{"y0", 100.0}, {"vy0", speed}, {"vx0", 0.0}, {"height", height}, {"dt", 0.01}});
  };
  Simulation below(bounce(), thrown(1000), scheme.name);
  double apex = 0;
  while (velocity(below).y > 0) {
    below.step();
    apex = std::max(apex, position(below).y);
  }
  Simulation low(bounce(), thrown(apex + 10.01), scheme.name), high(bounce(), thrown(1000), scheme.name);
  run_steps(low, 100);
  run_steps(high, 100);
  CHECK(same_state(low, high));
}

TEST_CASE("a disc that lies on the floor slides along it as if it were not there", "[stage1]") {
  const auto scheme = GENERATE(from_range(schemes()));
  const double gravity = GENERATE(0.0, 500.0);
  Simulation simulation(
      bounce(),
      typed({{"gravity", gravity}, {"drag", 0.0}, {"x0", 100.0}, {"y0", 10.0}, {"vx0", 150.0}, {"dt", 0.01}}),
      scheme.name);
  run_to(simulation, 4);
  CHECK(position(simulation).y == 10);
  CHECK(velocity(simulation).y == 0);
  CHECK(position(simulation).x == Approx(700).epsilon(1e-12));
  CHECK(velocity(simulation).x == 150);
  run_to(simulation, 5);  // 90 px to the wall, at 4.6 s, and back with 0.8 of the speed
  CHECK(position(simulation).x == Approx(790 - 0.4 * 0.8 * 150).epsilon(1e-12));
  CHECK(position(simulation).y == 10);
}

TEST_CASE("a particle on a wall may leave it at once", "[stage1]") {
  Simulation up(drop(), typed({{"y0", 0.0}, {"vy0", 3.0}}, 1.0, 500), "rk4");
  run_to(up, 1.0);
  const BouncingBall ball{0, 3, g, 1, 0.8};
  CHECK(position(up).y == Approx(ball.at(1.0).y).margin(1e-9));  // RK4 at 2 ms, one impact
  Simulation ceiling(bounce(), typed({{"y0", 590.0}, {"vx0", 0.0}, {"drag", 0.0}, {"dt", 0.01}}));
  run_to(ceiling, 0.5);
  CHECK(position(ceiling).y == Approx(590 - 500 * 0.25 / 2).epsilon(1e-12));
  Simulation into(drop(), typed({{"y0", 0.0}, {"vy0", -3.0}, {"drag", 0.0}, {"dt", 0.01}}));
  run_to(into, 0.2);
  CHECK(velocity(into).y == Approx(0.8 * 3 - g * 0.2).epsilon(1e-12));
}
