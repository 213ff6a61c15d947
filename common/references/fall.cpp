#include "common/references/fall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/references/lambert_w.hpp"

namespace clapotis {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = std::numeric_limits<double>::epsilon();

/// phi1(s) = (1 - exp(-s))/s
double phi1(double s) { return s == 0 ? 1 : -std::expm1(-s) / s; }

/// phi2(s) = (1 - phi1(s))/s; below s = 1 its power series, since 1 - phi1 would lose the leading digits.
double phi2(double s) {
  if (std::abs(s) >= 1) return (1 - phi1(s)) / s;
  double term = 0.5;
  double sum = term;
  for (int k = 3; std::abs(term) > round_off * sum / 4; ++k) {
    term *= -s / k;
    sum += term;
  }
  return sum;
}

/// Without drag; hypot keeps bounces of 1e-200 m/s from underflowing.
double landing_time_of_parabola(const Fall& f) {
  const double impact_speed = std::hypot(f.speed, std::sqrt(2 * f.gravity) * std::sqrt(f.height));
  if (f.speed < 0) return 2 * f.height / (impact_speed - f.speed);
  return (f.speed + impact_speed) / f.gravity;
}

/// The drag alone slows the ball: it comes down only if it starts fast enough.
double landing_time_without_gravity(const Fall& f) {
  if (f.speed >= 0) return infinity;
  const double straight = f.height / -f.speed;
  const double fraction = straight / f.drag_time;  // of the way that the ball can go at all
  if (fraction == 0) return straight;
  return fraction < 1 ? -f.drag_time * std::log1p(-fraction) : infinity;
}

/// s = a + W0(-b exp(-a)), A = (v0 + g tau) tau, a = (y0 + A)/(g tau^2), b = A/(g tau^2), t = s tau.
/// A short flight (s << 1) puts the argument on the branch point -1/e, where half of the digits of s are lost
/// at best: there the parabola is the better start. So it is where exp(-a) overflows (thrown down hard).
double landing_time_guess(const Fall& f) {
  const double b = 1 + f.speed / (f.gravity * f.drag_time);
  const double a = b + f.height / (f.gravity * f.drag_time * f.drag_time);
  const double x = -b * std::exp(-a);
  const bool usable = std::isfinite(a) && std::isfinite(x) && x > -0.35;
  return usable ? f.drag_time * (a + lambert_w0(x)) : landing_time_of_parabola(f);
}

}  // namespace

BallState Fall::at(double t) const {
  const double s = t / drag_time;
  const double fade = phi1(s);
  return {height + t * (speed * fade - gravity * t * phi2(s)), speed * std::exp(-s) - gravity * t * fade};
}

double Fall::landing_time() const {
  if (gravity == 0) return landing_time_without_gravity(*this);
  if (height == 0 && speed <= 0) return 0;
  if (std::isinf(drag_time)) return landing_time_of_parabola(*this);

  // Newton's iteration restores the last digits of the guess. It cannot fail: both guesses lie past the apex,
  // where the height falls and is concave (convex, if thrown down faster than the terminal speed g tau).
  double t = landing_time_guess(*this);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const BallState state = at(t);
    if (!(state.v < 0)) break;
    const double step = state.y / state.v;
    t = std::max(t - step, 0.0);
    if (std::abs(step) <= 2 * round_off * t) break;
  }
  return t;
}

}  // namespace clapotis
