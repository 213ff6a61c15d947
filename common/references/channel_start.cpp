#include "common/references/channel_start.hpp"

#include <cmath>
#include <numbers>

#include "common/references/require.hpp"

namespace clapotis {

double ChannelStart::velocity(double y, double t) const {
  const Demand demand{"ChannelStart"};
  demand.positive(depth, "depth [m]");
  demand.positive(viscosity, "viscosity [m^2/s]");
  if (!(t > 0)) return 0;
  double u = force * y * (depth - y) / (2 * viscosity) + plate_speed * y / depth;
  double sign = -1, left = 1;
  for (int n = 1; left > 1e-14 && n < 100000; ++n, sign = -sign) {
    const double k = n * std::numbers::pi / depth;
    left = std::exp(-viscosity * k * k * t);
    const double wave = std::sin(k * y) * left;
    u += sign * 2 * plate_speed / (k * depth) * wave;
    if (n % 2 == 1) u -= 4 * force / (viscosity * depth * k * k * k) * wave;
  }
  return u;
}

}  // namespace clapotis
