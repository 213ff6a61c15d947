#pragma once

namespace clapotis {

/// How much higher the pressure is inside a round drop of the plane: sigma/R [kg/(m s^2)], sigma [kg/s^2], R
/// its radius [m] > 0. Laplace 1806.
double laplace_jump(double sigma, double radius);

/// A round drop of the plane whose surface is a little wave, r = R (1 + epsilon(t) cos(n theta)), without
/// gravity: epsilon goes as exp(-decay t) cos(frequency t), for little viscosity.
struct DropMode {
  double radius;     ///< R [m], > 0
  double density;    ///< rho [kg/m^3], > 0
  double sigma;      ///< [kg/s^2], > 0
  double viscosity;  ///< nu [m^2/s], >= 0
  int n = 2;         ///< >= 2; 2 is a drop that is in turn long and wide

  /// sqrt(n (n^2 - 1) sigma/(rho R^3)) [1/s]. Rayleigh 1879, Proc. R. Soc. 29: 71-97, appendix.
  [[nodiscard]] double frequency() const;
  /// 2 n (n - 1) nu/R^2 [1/s], from what the motion of a liquid without viscosity dissipates. Lamb,
  /// Hydrodynamics, art. 348 and 355.
  [[nodiscard]] double decay() const;
  /// epsilon(t)/epsilon(0) of a drop that starts at rest.
  [[nodiscard]] double at(double t) const;
};

/// A drop of the plane on a plate, without gravity: the segment of a circle that meets the plate at the angle
/// theta [rad], 0 < theta < pi, inside the liquid. A circle, since the pressure is uniform; the angle is
/// Young's (1805).
struct CircularCap {
  double area;   ///< S [m^2], > 0
  double angle;  ///< theta [rad]

  [[nodiscard]] double radius() const;          ///< a = sqrt(S/(theta - sin theta cos theta)) [m]
  [[nodiscard]] double height() const;          ///< a (1 - cos theta) [m]
  [[nodiscard]] double width() const;           ///< of what it wets, 2 a sin theta [m]
  [[nodiscard]] double centre_of_mass() const;  ///< above the plate [m]
};
/// The angle of the cap of that area whose centre of mass is that far above the plate [rad]; 0 or pi where
/// no cap lies so low or so high.
double angle_of_cap(double area, double centre_of_mass);

}  // namespace clapotis
