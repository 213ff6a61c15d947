#include "common/references/released_column.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

using std::numbers::pi;

void check(const ReleasedColumn& c, double x, double y) {
  const Demand demand{"ReleasedColumn"};
  demand.positive(c.width, "width [m]");
  demand.positive(c.height, "height [m]");
  demand.positive(c.density, "density [kg/m^3]");
  demand.not_negative(c.gravity, "gravity [m/s^2]");
  demand.finite(x, "x [m]");
  demand.finite(y, "y [m]");
}

/// The sum of the header over a, up to the first term that cannot be seen: the sign of the terms changes.
/// With z = exp(k (i x - y)) and z' = exp(k (i x - 2 H + y)), a term is the real part of (z - z')/(1 + exp(-2
/// k H)), in which nothing overflows; from one term to the next, k grows by pi. All lengths in units of a.
double series(double x, double y, double height) {
  const auto wave = [&](double k, double down) { return std::polar(std::exp(-k * down), k * x); };
  constexpr double first = pi / 2;
  auto z = wave(first, y), mirrored = wave(first, 2 * height - y);
  const auto grow = wave(pi, y), grow_mirrored = wave(pi, 2 * height - y);
  double below = std::exp(-2 * first * height);
  const double grow_below = std::exp(-2 * pi * height);
  double sum = 0, sign = 1, bound = 1;
  for (double k = first; bound > 1e-9; k += pi, sign = -sign) {
    sum += sign * (z - mirrored).real() / (k * k * (1 + below));
    bound = (std::abs(z.real()) + std::abs(z.imag())) / (k * k);
    z *= grow;
    mirrored *= grow_mirrored;
    below *= grow_below;
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
