#pragma once

#include "common/references/require.hpp"

namespace clapotis {

/// A layer of viscous liquid, of even depth d, that flows down a slope: the component f = g sin(theta) of the
/// weight along the bed against the friction on it, no stress at the surface (Nusselt 1916):
///   u = f (d y - y^2/2)/nu.
struct FilmFlow {
  double depth;      ///< d [m], > 0
  double viscosity;  ///< nu [m^2/s], > 0
  double force;      ///< f [m/s^2]

  /// u at the height y above the bed [m/s]. Throws std::invalid_argument if a parameter is out of the range
  /// given here.
  [[nodiscard]] double velocity(double y) const {
    const Demand demand{"FilmFlow"};
    demand.positive(depth, "depth [m]");
    demand.positive(viscosity, "viscosity [m^2/s]");
    demand.finite(force, "force [m/s^2]");
    return force * y * (depth - y / 2) / viscosity;
  }
};

}  // namespace clapotis
