#include "common/references/lambert_w.hpp"

#include <cmath>
#include <limits>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

/// e = e_high + e_low to twice the digits of a double: e x + 1 then survives the cancellation near x = -1/e.
constexpr double e_high = 2.718281828459045;
constexpr double e_low = 1.4456468917292502e-16;
constexpr double branch_point = -0.36787944117144233;

/// Series at the branch point in p = sqrt(2 (e x + 1)); the first term left out is about 0.03 p^6.
double near_branch_point(double p) {
  return -1 + p * (1 + p * (-1.0 / 3 + p * (11.0 / 72 + p * (-43.0 / 540 + p * 769.0 / 17280))));
}

double first_guess(double x, double p) {
  if (x < 1) return p < 1 ? near_branch_point(p) : std::log1p(x);
  const double log_x = std::log(x);
  return x < 3 ? 0.7 * std::log1p(x) : log_x - std::log(log_x);
}

}  // namespace

double lambert_w0(double x) {
  require(x >= branch_point, "lambert_w0", "x", x, ">= -1/e");
  if (x == 0 || std::isinf(x)) return x;
  const double p = std::sqrt(std::fmax(0.0, 2 * (std::fma(e_high, x, 1.0) + e_low * x)));
  if (p < 2e-3) return near_branch_point(p);

  // Halley's iteration on w - x exp(-w), which cannot overflow where w exp(w) - x would.
  double w = first_guess(x, p);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double residual = w - x * std::exp(-w);
    const double step = residual / (w + 1 - (w + 2) * residual / (2 * (w + 1)));
    w -= step;
    if (std::abs(step) <= std::numeric_limits<double>::epsilon() * std::abs(w)) break;
  }
  return w;
}

}  // namespace clapotis
