#pragma once

namespace clapotis {

/// The pressure in a square patch of liquid of side L that turns like a rigid body at angular speed omega, at
/// the instant t = 0 at which it is let go; no gravity, p = 0 on the rim. The divergence of Euler's equation
/// for an incompressible liquid gives
///   lap p = -rho (u_x^2 + 2 u_y v_x + v_y^2) = 2 rho omega^2,
/// so the pressure is negative all over the patch: -0.147342706563 rho omega^2 L^2 in its centre. That is
/// what tears at particles, and makes the case a test of tensile instability.
///
/// With s the distance to the nearest pair of sides and r >= s that to the other pair, both over L,
///   p = rho omega^2 L^2 [-s (1 - s)
///       + sum over odd n of 8/(pi n)^3 sin(n pi s) cosh(n pi (1/2 - r))/cosh(n pi/2)],
/// the double series of Colagrossi 2005 with one of its sums done; its terms fall as exp(-n pi r). Right to
/// 2e-13 rho omega^2 L^2, close to the corners too, where many terms are needed: some hundreds at L/100, at
/// most 2e5. Colagrossi 2005, thesis, Universita di Roma La Sapienza, for the pressure; Le Touze, Colagrossi,
/// Colicchio and Greco 2013, Int. J. Numer. Meth. Fluids 73, for the case.
struct SquarePatch {
  double side;           ///< L [m], > 0
  double angular_speed;  ///< omega [rad/s], finite, either sense
  double density;        ///< rho [kg/m^3], > 0

  /// [Pa], at (x, y) [m] from the centre, axes along the sides; 0 outside the patch. Throws
  /// std::invalid_argument if a parameter is out of the range given here, or x or y not finite.
  double pressure(double x, double y) const;
};

}  // namespace clapotis
