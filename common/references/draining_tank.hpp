#pragma once

namespace clapotis {

/// The level of a tank that empties through a slot in its floor, by Torricelli's law: the jet leaves with
/// sqrt(2 g h) and contracts to a share C_c of the slot, so that
///   sqrt(h) = sqrt(h0) - C_c (b/W) sqrt(g/2) t.
/// C_c = pi/(pi + 2) for a slot narrow against the tank (Kirchhoff 1869; Lamb, Hydrodynamics, art. 75).
struct DrainingTank {
  double width;    ///< W [m], > 0
  double slot;     ///< b [m], > 0, < W
  double depth;    ///< h0 at t = 0 [m], > 0
  double gravity;  ///< g [m/s^2], > 0

  /// h(t) [m]; 0 when the tank is empty. Throws std::invalid_argument if a parameter is out of the range
  /// given here.
  [[nodiscard]] double level(double t) const;
};

}  // namespace clapotis
