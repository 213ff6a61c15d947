#include "common/references/spring_pair.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

double side(const SpringPair& p) { return p.x2 > p.x1 ? 1 : -1; }
double gap(const SpringPair& p) { return std::abs(p.x2 - p.x1) - 2 * p.radius; }
double closing_speed(const SpringPair& p) { return (p.v1 - p.v2) * side(p); }

void check(const SpringPair& p) {
  const Demand demand{"SpringPair"};
  demand.positive(p.stiffness, "stiffness [N/m]");
  demand.positive(p.radius, "radius [m]");
  demand.positive(p.mass1, "mass1 [kg]");
  demand.positive(p.mass2, "mass2 [kg]");
  demand.finite(p.x1, "x1 [m]");
  demand.finite(p.x2, "x2 [m]");
  demand.finite(p.v1, "v1 [m/s]");
  demand.finite(p.v2, "v2 [m/s]");
  require(gap(p) >= 0, "SpringPair", "gap |x2 - x1| - 2 radius [m]", gap(p), ">= 0 at the start");
  const double w = std::sqrt(p.stiffness / p.mass1 + p.stiffness / p.mass2);
  require(closing_speed(p) < 2 * p.radius * w, "SpringPair", "closing speed [m/s]", closing_speed(p),
          "below 2 radius sqrt(k/mu), or the centres pass through each other");
}

}  // namespace

double SpringPair::angular_frequency() const {
  check(*this);
  return std::sqrt(stiffness / mass1 + stiffness / mass2);
}

double SpringPair::contact_begin() const {
  check(*this);
  const double closing = closing_speed(*this);
  return closing > 0 ? gap(*this) / closing : std::numeric_limits<double>::infinity();
}

double SpringPair::contact_end() const { return contact_begin() + std::numbers::pi / angular_frequency(); }

double SpringPair::max_overlap() const {
  const double w = angular_frequency();
  return std::fmax(closing_speed(*this), 0.0) / w;
}

SpringPair::State SpringPair::at(double t) const {
  const double begin = contact_begin();
  const double end = contact_end();
  // What the contact has taken, since its beginning, from the distance and the closing speed of free flight.
  double pushed = 0, closing_lost = 0;
  if (t > begin) {
    const double closing = closing_speed(*this);
    const double w = angular_frequency();
    const double since = t - begin;
    const double overlap = closing / w * std::sin(w * since);
    pushed = t < end ? closing * since - overlap : closing * (since + (t - end));
    closing_lost = t < end ? closing * (1 - std::cos(w * since)) : 2 * closing;
  }
  // Shared in inverse proportion to the masses, so that the centre of mass does not notice.
  const double share1 = -side(*this) * mass2 / (mass1 + mass2);
  const double share2 = side(*this) * mass1 / (mass1 + mass2);
  return {x1 + v1 * t + share1 * pushed, x2 + v2 * t + share2 * pushed, v1 + share1 * closing_lost,
          v2 + share2 * closing_lost};
}

double explicit_euler_amplification(double w_dt) { return 1 + w_dt * w_dt; }

double explicit_euler_restitution(double w_dt) {
  Demand{"explicit_euler_restitution"}.positive(w_dt, "w dt");
  return std::exp(std::log1p(w_dt * w_dt) * std::numbers::pi / (2 * w_dt));
}

}  // namespace clapotis
