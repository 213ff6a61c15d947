#pragma once

namespace clapotis {

/// The flow of a viscous liquid between two plates at y = 0 and y = d that starts from rest at t = 0: driven
/// by a force f per unit of mass (Poiseuille), or by the upper plate, which moves at U from then on
/// (Couette). With k = n pi/d,
///   u = f y (d - y)/(2 nu) - sum over odd n of 4 f/(nu d k^3) sin(k y) exp(-nu k^2 t)
///     + U y/d + sum over n of (-1)^n 2 U/(k d) sin(k y) exp(-nu k^2 t).
/// Morris, Fox & Zhu 1997, J. Comput. Phys. 136, equations 21 and 22. Right to 1e-12 of the steady flow for t
/// > 0.
struct ChannelStart {
  double depth;            ///< d [m], > 0
  double viscosity;        ///< nu [m^2/s], > 0
  double force = 0;        ///< f [m/s^2]
  double plate_speed = 0;  ///< U [m/s]

  /// u(y, t) [m/s] for 0 <= y <= d; before t = 0 nothing moves. Throws std::invalid_argument if a parameter
  /// is out of the range given here.
  double velocity(double y, double t) const;
};

}  // namespace clapotis
