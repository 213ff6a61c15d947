#include <cmath>
#include <string>

#include "common/laws/dummy_walls.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/brute_force.hpp"
#include "tests/stage4/clouds.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

// Some hundred terms, each right to some units in the last place, in another order: about 1e-14 of their
// magnitudes; pressure is the seventh power of a density, and reaches the walls and then the acceleration.
constexpr double as_exact = 1e-12;

/// Compares everything that the model of the cloud computes with the formulas.
void compare(const Cloud& cloud, const Values& values) {
  Simulation sim(scene_of(cloud), typed(values));
  auto liquid = Liquid::from(sim.parameters());
  liquid.period = cloud.period;
  const auto* walls = sim.model().wall_particles();
  const Vectors places = walls != nullptr ? walls->places : Vectors(0, 2);
  const auto exact = brute_force(liquid, cloud.position, cloud.velocity, cloud.density, places);
  REQUIRE(sim.particles().size() == cloud.position.rows());
  CHECK(sim.model().count_pairs(sim.particles()).neighbours == exact.neighbours);
  sim.look([&](const System& s) {
    CHECK(difference(s.density, exact.density) < as_exact);
    CHECK(difference(s.particles.pressure, exact.pressure) < as_exact);
    CHECK(difference(s.acceleration.col(0), exact.ax) < as_exact);
    CHECK(difference(s.acceleration.col(1), exact.ay) < as_exact);
  });
  if (walls != nullptr) {
    REQUIRE(walls->size() > 100);
    CHECK(difference(walls->columns.pressure.head(walls->size()), exact.wall_pressure) < as_exact);
  }
  if (liquid.sum) return;
  sim.system().evaluate_density_rate();
  CHECK(difference(sim.system().density_rate, exact.rate) < as_exact);
}

}  // namespace

TEST_CASE("a liquid obeys the formulas of the textbook, with and without walls and edges", "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string density = GENERATE("continuity", "summation");
  const double h = GENERATE(1.3, 2.0);
  const std::string where = GENERATE("free", "tank", "periodic", "periodic along x", "periodic along y");
  Cloud cloud = random_cloud(1, 7);
  cloud.in_tank = where == "tank";
  if (where == "periodic" || where == "periodic along x") cloud.period.x = 1;
  if (where == "periodic" || where == "periodic along y") cloud.period.y = 1;
  Values values{
      {"kernel", kernel}, {"density", density}, {"h_over_dx", h}, {"tension", "yes"}, {"alpha", 0.3}};
  if (cloud.in_tank) {
    values.emplace_back("tank_width", 1.0);
    values.emplace_back("tank_height", 0.8);  // so that some stand above the rim
  }
  if (density == "continuity") values.emplace_back("delta", 0.1);
  CAPTURE(kernel, density, h, where);
  compare(cloud, values);
}

TEST_CASE("a viscous liquid obeys the formulas too, where walls hold it and where it slips", "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string density = GENERATE("continuity", "summation");
  const std::string slip = GENERATE("no", "free");
  const bool in_tank = GENERATE(true, false);
  Cloud cloud = random_cloud(1, 8);
  cloud.in_tank = in_tank;
  if (!in_tank) cloud.period = {1, 1};
  Values values{{"kernel", kernel}, {"density", density}, {"h_over_dx", 1.3}, {"nu", 0.3}, {"slip", slip}};
  if (in_tank) {
    values.emplace_back("tank_width", 1.0);
    values.emplace_back("tank_height", 1.0);
  }
  CAPTURE(kernel, density, slip, in_tank);
  compare(cloud, values);
}

TEST_CASE("a liquid that bears no tension obeys the formulas with pressures of 0 and more", "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  Cloud cloud = random_cloud(1, 9);
  cloud.in_tank = GENERATE(true, false);
  Values values{{"kernel", "wendland_c2"}, {"density", density}, {"h_over_dx", 1.3}};
  if (cloud.in_tank) values.emplace_back("tank_width", 1.0);
  CAPTURE(density, cloud.in_tank);
  compare(cloud, values);
}

TEST_CASE("a liquid under tension obeys the formulas with what keeps it from clumping", "[stage4]") {
  const std::string kernel = GENERATE("cubic_spline", "wendland_c2");
  const std::string density = GENERATE("continuity", "summation");
  Cloud cloud = random_cloud(1, 10);
  cloud.corrected = true;
  CAPTURE(kernel, density);
  compare(cloud, {{"kernel", kernel}, {"density", density}, {"tension", "yes"}, {"epsilon", 0.7}});
}

TEST_CASE("any number of particles gives the sums of the formulas, also fewer than a pack holds",
          "[stage4]") {
  const std::string density = GENERATE("continuity", "summation");
  for (Index n = 1; n <= 40; ++n)
    for (const double side : {0.02, 0.3, 2.0}) {  // all within one support, some, hardly any
      Cloud cloud{.position = random_points(n, {0, side, 0, side}, static_cast<std::uint64_t>(n)),
                  .velocity = random_points(n, {-1, 1, -1, 1}, 3)};
      cloud.density = 1000 * random_points(n, {0.97, 1.05, 0, 1}, 4).col(0);
      CAPTURE(n, side);
      compare(cloud, {{"density", density}, {"tension", "yes"}, {"gamma", 1.5}});
    }
}

TEST_CASE("a plane that repeats itself after little more than one support obeys the formulas", "[stage4]") {
  // each particle then meets several images of the others
  const std::string density = GENERATE("continuity", "summation");
  Cloud cloud = random_cloud(0.25, 5, 0.02);
  cloud.period = {0.25, 0.25};
  compare(cloud, {{"density", density}, {"spacing", 0.05}, {"h_over_dx", 2.0}, {"tension", "yes"}});
}
