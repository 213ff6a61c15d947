#include "common/references/square_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

using std::numbers::pi;

void check(const SquarePatch& p, double x, double y) {
  const Demand demand{"SquarePatch"};
  demand.positive(p.side, "side [m]");
  demand.finite(p.angular_speed, "angular_speed [rad/s]");
  demand.positive(p.density, "density [kg/m^3]");
  demand.finite(x, "x [m]");
  demand.finite(y, "y [m]");
}

/// The sum over odd n of the header, up to the first term that cannot be seen. The two cosh are written with
/// exponentials that cannot overflow.
double series(double s, double r) {
  double sum = 0;
  double bound = 1;
  for (double n = 1; bound > 1e-17; n += 2) {
    bound = std::exp(-n * pi * r) / (n * n * n);
    sum += bound * std::sin(n * pi * s) * (1 + std::exp(-n * pi * (1 - 2 * r))) / (1 + std::exp(-n * pi));
  }
  return 8 / (pi * pi * pi) * sum;
}

}  // namespace

double SquarePatch::pressure(double x, double y) const {
  check(*this, x, y);
  const double from_x_sides = 0.5 - std::abs(x) / side;
  const double from_y_sides = 0.5 - std::abs(y) / side;
  const auto [s, r] = std::minmax({from_x_sides, from_y_sides});
  if (s <= 0) return 0;
  const double rim_speed = angular_speed * side;
  return density * rim_speed * rim_speed * (series(s, r) - s * (1 - s));
}

}  // namespace clapotis
