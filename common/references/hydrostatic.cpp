#include "common/references/hydrostatic.hpp"

#include <algorithm>
#include <cmath>

#include "common/references/require.hpp"

namespace clapotis {

namespace {

void check(const HydrostaticColumn& w, double depth) {
  const Demand demand{"HydrostaticColumn"};
  demand.positive(w.surface_density, "surface_density [kg/m^3]");
  demand.positive(w.sound_speed, "sound_speed [m/s]");
  require(w.gamma >= 1 && std::isfinite(w.gamma), demand.where, "gamma", w.gamma, "finite and >= 1");
  demand.not_negative(w.gravity, "gravity [m/s^2]");
  demand.finite(depth, "depth [m]");
}

/// ln(rho/rho0). From it both functions follow by exp, which is exact to round-off where a power would not
/// be.
double log_compression(const HydrostaticColumn& w, double depth) {
  check(w, depth);
  const double zeta = w.gravity * std::max(depth, 0.0) / (w.sound_speed * w.sound_speed);
  const double excess = w.gamma - 1;
  return excess == 0 ? zeta : std::log1p(excess * zeta) / excess;
}

}  // namespace

double HydrostaticColumn::pressure(double depth) const {
  const double bulk_modulus = surface_density * sound_speed * sound_speed;
  return bulk_modulus / gamma * std::expm1(gamma * log_compression(*this, depth));
}

double HydrostaticColumn::density(double depth) const {
  return surface_density * std::exp(log_compression(*this, depth));
}

double HydrostaticColumn::compressed(double height) const {
  check(*this, height);
  if (gravity == 0) return height;
  const double length = sound_speed * sound_speed / gravity, excess = gamma - 1;
  const double log_compression = std::log1p(gamma * std::max(height, 0.0) / length) / gamma;
  return length * (excess == 0 ? log_compression : std::expm1(excess * log_compression) / excess);
}

}  // namespace clapotis
