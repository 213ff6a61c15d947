#pragma once

namespace clapotis {

/// A drop that is a disc of radius R at t = 0 and stretches along y, by inertia alone: incompressible, no
/// gravity, no viscosity, p = 0 on the rim. It stays an ellipse of semi-axes a along x and b = R^2/a along y,
/// and its velocity stays a uniform strain, u = -A x, v = A y. Euler's equation demands
///   dA/dt = A^2 (a^4 - R^4)/(a^4 + R^4),   da/dt = -A a,
///   p = p0 (1 - x^2/a^2 - y^2/b^2),   p0 = rho a^2 (A^2 - dA/dt)/2.
///
/// The kinetic energy per unit depth, E = rho/8 pi a b (a^2 + b^2) A^2, cannot change: it is a first
/// integral, from which all follows. With the elongation theta = ln(b/R) and s = sqrt(cosh 2 theta),
///   A = A0/s,   p0 = rho (R A0)^2/(2 s^4),   A0 t = integral of s from 0 to theta.
/// The integral is elliptic; it is summed by Gauss' rule and solved for theta by Newton's, so `at` has the
/// error of round-off at any time, and no memory. Monaghan 1994, J. Comput. Phys. 110, for the case and its
/// equations (R = 1); their integral is derived here.
///
/// Both functions throw std::invalid_argument if a parameter is out of the range given here, or A0 t not
/// finite.
struct EllipticalDrop {
  double radius;       ///< R [m], > 0
  double strain_rate;  ///< A0 = A at t = 0 [1/s], > 0
  double density;      ///< rho [kg/m^3], > 0

  struct State {
    double strain_rate;      ///< A [1/s]
    double semi_axis_x;      ///< a [m]
    double semi_axis_y;      ///< b [m]
    double centre_pressure;  ///< p0 [Pa]

    double pressure(double x, double y) const;  ///< [Pa], at (x, y) [m] from the centre; 0 outside the drop
  };

  /// At t [s] of either sign: before t = 0 the drop was long along x, a(-t) = b(t) and A(-t) = A(t).
  State at(double t) const;

  double kinetic_energy() const;  ///< E = pi/4 rho R^4 A0^2 at any time, per unit depth [J/m]
};

}  // namespace clapotis
