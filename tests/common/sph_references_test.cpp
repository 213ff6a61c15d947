#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/references/hydrostatic.hpp"
#include "tests/catch.hpp"

using namespace clapotis;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double round_off = std::numeric_limits<double>::epsilon();

/// A tank one metre deep whose water carries sound at the speed that SPH gives it, c^2 = 200 g H.
HydrostaticColumn tank_of_sph(double gamma) { return {1000, std::sqrt(200 * 9.81), gamma, 9.81}; }

}  // namespace

TEST_CASE("in still water the pressure carries the weight above it and squeezes it by Cole's equation",
          "[references]") {
  const double gamma = GENERATE(1.0, 1.0000001, 1.4, 7.0);
  const double sound_speed = GENERATE(3.0, 44.0, 1500.0);
  const HydrostaticColumn water{1000, sound_speed, gamma, 9.81};
  // Central differences: dz^2/6 p''' is at most 4e-7 of rho g (c = 3 m/s, gamma = 7); round-off is 1e-9 of
  // it.
  const double dz = 1e-3;
  for (double z = 0.1; z < 1.05; z += 0.1) {
    const double rho = water.density(z);
    const double slope = (water.pressure(z + dz) - water.pressure(z - dz)) / (2 * dz);
    const double cole = 1000 * sound_speed * sound_speed / gamma * (std::pow(rho / 1000, gamma) - 1);
    CAPTURE(gamma, sound_speed, z);
    CHECK(slope == Approx(rho * 9.81).epsilon(5e-7));
    // Cole's difference of powers keeps no more than round-off times rho0 c^2.
    CHECK(std::abs(water.pressure(z) - cole) < 4 * round_off * 1000 * sound_speed * sound_speed);
  }
}

TEST_CASE("the bottom of a tank of SPH water bears a quarter of a per cent more than rho g H",
          "[references]") {
  // p/(rho g H) for zeta = g H/c^2 = 1/200, computed with 30 digits. The tank's c^2 is off by round-off.
  CHECK(tank_of_sph(7).pressure(1) / 9810 == Approx(1.00247944834665394).epsilon(8 * round_off));
  CHECK(tank_of_sph(1).pressure(1) / 9810 == Approx(1.00250417188021268).epsilon(8 * round_off));
  CHECK(tank_of_sph(1.000001).pressure(1) / 9810 == Approx(1.00250417187603035).epsilon(8 * round_off));
  CHECK(tank_of_sph(7).density(1) == Approx(1000 * std::pow(1.03, 1.0 / 6)).epsilon(8 * round_off));
  // Deep down: zeta = 1/2, where water of gamma = 7 has grown a quarter denser.
  CHECK(HydrostaticColumn{1, 1, 7, 1}.pressure(0.5) == Approx(0.57709774279707038).epsilon(8 * round_off));
  CHECK(HydrostaticColumn{1, 1, 7, 1}.density(0.5) == Approx(std::pow(4, 1.0 / 6)).epsilon(8 * round_off));
}

TEST_CASE("water that sound crosses at once bears rho g z, without losing a digit", "[references]") {
  const HydrostaticColumn stiff{1000, 1e9, GENERATE(1.0, 7.0), 9.81};
  CHECK(stiff.pressure(3) == Approx(29430).epsilon(8 * round_off));
  CHECK(stiff.density(3) == 1000);
  CHECK(HydrostaticColumn{1000, 44, 7, 0}.pressure(3) == 0);  // weightless
}

TEST_CASE("above still water there is nothing to press", "[references]") {
  CHECK(tank_of_sph(7).pressure(0) == 0);
  CHECK(tank_of_sph(7).pressure(-0.3) == 0);
  CHECK(tank_of_sph(7).density(-0.3) == 1000);
}

TEST_CASE("still water out of the physical range is refused", "[references]") {
  CHECK_THROWS_AS((HydrostaticColumn{0, 44, 7, 9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, -44, 7, 9.81}.density(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, infinity, 7, 9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS((HydrostaticColumn{1000, 44, 7, -9.81}.pressure(1)), std::invalid_argument);
  CHECK_THROWS_AS(tank_of_sph(not_a_number).pressure(1), std::invalid_argument);
  CHECK_THROWS_AS(tank_of_sph(7).pressure(not_a_number), std::invalid_argument);
  CHECK_THROWS_WITH(tank_of_sph(0.5).pressure(1),
                    "HydrostaticColumn: gamma is 0.5, it must be finite and >= 1");
}
