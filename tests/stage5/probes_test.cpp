#include "stage5_extensions/probes.hpp"

#include "common/simulation/errors.hpp"
#include "stage4_sph/liquid.hpp"
#include "stage5_extensions/scenes.hpp"
#include "tests/catch.hpp"
#include "tests/stage4/state.hpp"

using namespace clapotis;
using namespace clapotis::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

Simulation still_tank(const std::string& name, Values more = {}) {
  const Values still{{"amplitude", 0.0}, {"spacing", 0.05}, {"h_over_dx", 2.0}};
  more.insert(more.begin(), still.begin(), still.end());  // the later one counts
  return Simulation(stage5::stage().scene(name), typed(more));
}

}  // namespace

TEST_CASE("at rest a pressure probe on a wall shows the weight of the water above it within 0.1 %",
          "[stage5]") {
  const double spacing = GENERATE(0.05, 0.025);
  auto tank = still_tank("sloshing", {{"spacing", spacing}, {"probe_y", "0,0.1,0.25,0.45"}});
  const auto column = stage4::at_rest(tank.parameters());
  const double surface = column.compressed(0.5);
  for (const auto* wall : {"left", "right"})
    for (const double y : {0.0, 0.1, 0.25, 0.45}) {
      // A plane does not see how the pressure bends, by rho g h^2/(200 H): water compresses by 0.5 %.
      const double pressure = column.pressure(surface - y);
      CAPTURE(spacing, wall, y);
      CHECK(measure(tank, std::string("pressure_") + wall + "_" + to_text(y)) ==
            Approx(pressure).margin(0.001 * 1000 * 9.81 * 0.5));
    }
}

TEST_CASE("above the water there is no pressure, and none under tension", "[stage5]") {
  auto tank = still_tank("sloshing", {{"probe_y", "0.52,0.7"}});
  CHECK(measure(tank, "pressure_left_0.7") == 0);   // nothing near
  CHECK(measure(tank, "pressure_left_0.52") == 0);  // water near, but below
}

TEST_CASE("a tank in which nothing happens has no reference, and no error", "[stage5]") {
  const std::string name = GENERATE("sloshing", "standing_wave");
  auto tank = still_tank(name);
  CHECK(!tank.setup().reference);
  run_until(tank, 0.05);
  CHECK(std::isnan(tank.error()));
}

TEST_CASE("a wave probe stands where it is asked for, between the walls", "[stage5]") {
  auto tank = still_tank("sloshing", {{"amplitude", 0.02}, {"spacing", 0.025}, {"probe_x", "0,0.5,1"}});
  run_until(tank, 0.3);
  CHECK(measure(tank, "elevation_0") == measure(tank, "elevation_left"));
  CHECK(measure(tank, "elevation_1") == measure(tank, "elevation_right"));
  // In the middle all odd modes have a knot; what is left is of second order in the wave's steepness.
  CHECK(std::abs(measure(tank, "elevation_0")) > 0.01);
  CHECK(std::abs(measure(tank, "elevation_0.5")) < 0.1 * std::abs(measure(tank, "elevation_0")));
  CHECK_THROWS_WITH(still_tank("sloshing", {{"probe_x", "0.5,1.5"}}),
                    ContainsSubstring("probe_x = 1.5 m is out of range") &&
                        ContainsSubstring("between 0 and 1 m each, with commas between, or none"));
}

TEST_CASE("a tank that needs no time to swing is refused", "[stage5]") {
  CHECK_THROWS_WITH(still_tank("sloshing", {{"period", 0.0}}),
                    ContainsSubstring("period = 0 s is out of range: period must be > 0 s"));
}
