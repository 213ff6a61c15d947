#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "common/references/released_column.hpp"
#include "tests/catch.hpp"

using namespace clapotis;
using std::numbers::pi;

TEST_CASE("the pressure in a column set free balances its weight on the bed and nothing on its face",
          "[references]") {
  const ReleasedColumn column{1, 2, 1000, 10};  // rho g a = 10,000 Pa
  const double d = 1e-3;
  for (double y = 0.05; y < 1.95; y += 0.13)
    for (double x = 0.05; x < 0.95; x += 0.1) {
      CAPTURE(x, y);
      const double here = column.pressure(x, y);
      const double around = column.pressure(x + d, y) + column.pressure(x - d, y) +
                            column.pressure(x, y + d) + column.pressure(x, y - d);
      CHECK(std::abs(around - 4 * here) < 1e-4);  // the sum is right to 1e-5 Pa
      CHECK(here > 0);
      CHECK(here < 10000 * (2 - y));
    }
  for (double s = 0.05; s < 0.9; s += 0.1) {
    CAPTURE(s);
    // One-sided differences of order 2; p_yyy is at most 2 rho g/(1 - x)^2.
    const double on_bed =
        (4 * column.pressure(s, d) - column.pressure(s, 2 * d) - 3 * column.pressure(s, 0)) / (2 * d);
    CHECK(on_bed == Approx(-10000).margin(1 + 1e4 * d * d / ((1 - s) * (1 - s))));
    CHECK(column.pressure(d, s) == Approx(column.pressure(0, s)).epsilon(1e-5));  // p_x = 0 at the wall
    CHECK(column.pressure(1 - 1e-9, s) == Approx(0).margin(1e-3));
    CHECK(column.pressure(s, 2 - 1e-9) == Approx(0).margin(1e-3));
  }
}

TEST_CASE("a high column set free and a wide one have the pressures of their limits", "[references]") {
  // However high, 8/pi^2 times Catalan's constant at the foot of the wall; hydrostatic where the gate is far.
  CHECK(ReleasedColumn{1, 50, 1, 1}.pressure(0, 0) ==
        Approx(8 * 0.915965594177219 / (pi * pi)).epsilon(1e-8));
  CHECK(ReleasedColumn{50, 1, 1, 1}.pressure(0, 0.25) == Approx(0.75).epsilon(1e-6));
  CHECK(ReleasedColumn{1, 2, 1, 1}.pressure(1.5, 1) == 0);
  CHECK(ReleasedColumn{1, 2, 1, 0}.pressure(0.5, 1) == 0);
  CHECK_THROWS_WITH((ReleasedColumn{1, 2, 0, 1}.pressure(0, 0)),
                    "ReleasedColumn: density [kg/m^3] is 0, it must be finite and > 0");
  CHECK_THROWS_AS((ReleasedColumn{1, 2, 1, 1}.pressure(std::numeric_limits<double>::quiet_NaN(), 0)),
                  std::invalid_argument);
}
