#pragma once

namespace clapotis {

/// The pressure in a column of an incompressible liquid, 0 <= x <= a and 0 <= y <= H, at the instant t = 0 at
/// which the gate before it vanishes: it stands between a wall at x = 0, the bed at y = 0, and air, with p =
/// 0, at x = a and y = H. Nothing moves yet, so Euler's equation has lap p = 0, with p_x = 0 at the wall and
/// p_y = -rho g on the bed. Separation of the variables gives, with k = (n + 1/2) pi/a,
///   p = 2 rho g/a sum over n >= 0 of (-1)^n cos(k x) sinh(k (H - y)) / (k^2 cosh(k H)),
/// less than the hydrostatic rho g (H - y) everywhere, and at most 0.7425 rho g a however high the column is.
/// A column that starts with the hydrostatic pressure instead bursts through its face at p/(rho c), faster
/// with every refinement. Right to 1e-9 rho g a; the terms fall as exp(-k y), some hundreds at y = a/100.
struct ReleasedColumn {
  double width;    ///< a [m], > 0
  double height;   ///< H [m], > 0
  double density;  ///< rho [kg/m^3], > 0
  double gravity;  ///< g [m/s^2], >= 0, downward

  /// [Pa]; 0 outside the column. Throws std::invalid_argument if a parameter is out of the range given here,
  /// or x or y not finite.
  double pressure(double x, double y) const;
};

}  // namespace clapotis
