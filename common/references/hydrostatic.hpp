#pragma once

namespace clapotis {

/// A weakly compressible liquid at rest under gravity. The Cole equation p = rho0 c^2/gamma ((rho/rho0)^gamma
/// - 1) and dp/dz = rho g, z the depth under the surface where p = 0, give with zeta = g z/c^2
///   rho = rho0 (1 + (gamma - 1) zeta)^(1/(gamma - 1)),
///   p = rho0 c^2/gamma [(1 + (gamma - 1) zeta)^(gamma/(gamma - 1)) - 1],
/// and rho = rho0 exp(zeta), p = rho0 c^2 (exp(zeta) - 1) for gamma = 1. As c grows, p tends to rho0 g z,
/// which it exceeds by the part zeta/2: 0.25 % at the bottom of a tank of depth H with c^2 = 200 g H. No
/// digit is lost, also close to gamma = 1 and for large c. Any consistent units. Cole 1948, Underwater
/// Explosions, for the equation of state; Monaghan 1994, J. Comput. Phys. 110, for its use in SPH.
///
/// All functions throw std::invalid_argument if a parameter is out of the range given here, or the depth is
/// not finite.
struct HydrostaticColumn {
  double surface_density;  ///< rho0 [kg/m^3], > 0
  double sound_speed;      ///< c at the surface [m/s], > 0
  double gamma;            ///< exponent, no unit, >= 1; 7 for water
  double gravity;          ///< g [m/s^2], >= 0, downward

  /// At depth z [m]. Above the surface (z < 0) there is no liquid: p = 0 and rho = rho0, as on it.
  double pressure(double depth) const;  ///< [Pa]
  double density(double depth) const;   ///< [kg/m^3]
  /// What depth [m] a column of liquid of rho0 and the given height [m] is pressed together to by its own
  /// weight.
  double compressed(double height) const;
};

}  // namespace clapotis
