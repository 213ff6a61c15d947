#include "common/references/elliptical_drop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

void check(const EllipticalDrop& d) {
  const Demand demand{"EllipticalDrop"};
  demand.positive(d.radius, "radius [m]");
  demand.positive(d.strain_rate, "strain_rate [1/s]");
  demand.positive(d.density, "density [kg/m^3]");
}

/// s = sqrt(cosh 2 theta), which cosh itself would let overflow early.
double root_cosh(double theta) { return std::hypot(std::exp(theta), std::exp(-theta)) / std::numbers::sqrt2; }

/// A0 t at which the drop has the elongation theta: Gauss' rule with eight points on panels of at most 1/4.
/// The nearest branch point of s is at i pi/4, far enough for an error of 1e-17 per panel.
double time_to_reach(double theta) {
  struct Node {
    double at, weight;
  };
  constexpr std::array<Node, 4> gauss{{{0.18343464249564980, 0.36268378337836198},
                                       {0.52553240991632899, 0.31370664587788729},
                                       {0.79666647741362674, 0.22238103445337447},
                                       {0.96028985649753623, 0.10122853629037626}}};
  const int panels = 1 + static_cast<int>(4 * std::abs(theta));
  const double half = theta / (2 * panels);
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (2 * panel + 1) * half;
    for (const auto& [at, weight] : gauss) {
      sum += weight * (root_cosh(middle - half * at) + root_cosh(middle + half * at));
    }
  }
  return half * sum;
}

/// theta at A0 t. Newton's iteration cannot fail: s >= cosh, so asinh(A0 t) lies beyond the root, on the side
/// from which the convex curve leads straight to it.
double elongation(double time) {
  double theta = std::asinh(time);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double step = (time_to_reach(theta) - time) / root_cosh(theta);
    theta -= step;
    if (std::abs(step) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(theta)) break;
  }
  return theta;
}

}  // namespace

EllipticalDrop::State EllipticalDrop::at(double t) const {
  check(*this);
  const double time = strain_rate * t;
  require(std::isfinite(time), "EllipticalDrop", "strain_rate t", time, "finite");
  const double theta = elongation(time);
  const double s = root_cosh(theta);
  const double rim_speed = radius * strain_rate / s;
  return {strain_rate / s, radius * std::exp(-theta), radius * std::exp(theta),
          density / 2 * (rim_speed / s) * (rim_speed / s)};
}

double EllipticalDrop::kinetic_energy() const {
  check(*this);
  const double rim_speed = radius * strain_rate;
  return std::numbers::pi / 4 * density * radius * radius * rim_speed * rim_speed;
}

double EllipticalDrop::State::pressure(double x, double y) const {
  const double from_centre = std::hypot(x / semi_axis_x, y / semi_axis_y);
  return centre_pressure * std::max((1 - from_centre) * (1 + from_centre), 0.0);
}

}  // namespace clapotis
