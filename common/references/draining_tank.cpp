#include "common/references/draining_tank.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

double DrainingTank::level(double t) const {
  const Demand demand{"DrainingTank"};
  demand.positive(width, "width [m]");
  demand.positive(slot, "slot [m]");
  demand.positive(depth, "depth [m]");
  demand.positive(gravity, "gravity [m/s^2]");
  require(slot < width, "DrainingTank", "slot [m]", slot, "< width");
  constexpr double contraction = std::numbers::pi / (std::numbers::pi + 2);
  const double root = std::sqrt(depth) - contraction * slot / width * std::sqrt(gravity / 2) * t;
  return std::pow(std::max(root, 0.0), 2);
}

}  // namespace clapotis
