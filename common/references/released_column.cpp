#include "common/references/released_column.hpp"

#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

void check(const ReleasedColumn& c, double x, double y) {
  const auto demand = [](bool holds, const char* name, double value, const char* range) {
    require(holds, "ReleasedColumn", name, value, range);
  };
  demand(c.width > 0 && std::isfinite(c.width), "width [m]", c.width, "finite and > 0");
  demand(c.height > 0 && std::isfinite(c.height), "height [m]", c.height, "finite and > 0");
  demand(c.density > 0 && std::isfinite(c.density), "density [kg/m^3]", c.density, "finite and > 0");
  demand(c.gravity >= 0 && std::isfinite(c.gravity), "gravity [m/s^2]", c.gravity, "finite and >= 0");
  demand(std::isfinite(x), "x [m]", x, "finite");
  demand(std::isfinite(y), "y [m]", y, "finite");
}

/// The sum of the header over a, up to the first term that cannot be seen: the sign of the terms changes. The
/// hyperbolic functions are written with exponentials that cannot overflow. All lengths in units of a.
double series(double x, double y, double height) {
  double sum = 0, sign = 1, bound = 1;
  for (double k = std::numbers::pi / 2; bound > 1e-9; k += std::numbers::pi, sign = -sign) {
    bound = std::exp(-k * y) / (k * k);
    sum +=
        sign * bound * std::cos(k * x) * -std::expm1(-2 * k * (height - y)) / (1 + std::exp(-2 * k * height));
  }
  return 2 * sum;
}

}  // namespace

double ReleasedColumn::pressure(double x, double y) const {
  check(*this, x, y);
  if (x < 0 || x >= width || y < 0 || y >= height) return 0;
  return density * gravity * width * series(x / width, y / width, height / width);
}

}  // namespace clapotis
