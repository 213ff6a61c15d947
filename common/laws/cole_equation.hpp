#pragma once

#include <cmath>

namespace clapotis {

/// Pressure of a weakly compressible liquid: p = rho_0 c^2/gamma ((rho/rho_0)^gamma - 1). Cole 1948; handout,
/// section VI. A liquid that bears no tension has p >= 0: what is less dense than rho_0 lies at a free
/// surface, where neighbours are missing, or has been torn apart.
struct ColeEquation {
  double reference_density;  ///< rho_0 [kg/L^3], > 0
  double sound_speed;        ///< c at rho_0 [L/s], > 0
  double gamma;              ///< polytropic exponent, >= 1; 7 for water
  bool tension;              ///< whether negative pressures are kept

  [[nodiscard]] double pressure(double density) const {
    const double p = stiffness() * (power(density / reference_density, gamma) - 1);
    return tension || !(p < 0) ? p : 0;  // a NaN stays one, to be found
  }
  /// The density that goes with a pressure, for the particles of walls.
  [[nodiscard]] double density(double pressure) const {
    return reference_density * std::pow(1 + pressure / stiffness(), 1 / gamma);
  }
  /// Energy of compression per unit of mass, the integral of p/rho^2 d rho from rho_0 [L^2/s^2].
  [[nodiscard]] double energy(double density) const {
    const double s = density / reference_density;
    if (s < 1 && !tension) return 0;
    const double work = gamma == 1 ? std::log(s) : (power(s, gamma - 1) - 1) / (gamma - 1);
    return sound_speed * sound_speed / gamma * (work + 1 / s - 1);
  }

 private:
  [[nodiscard]] double stiffness() const { return reference_density * sound_speed * sound_speed / gamma; }

  /// a^b, by products where b is a small whole number, as gamma is for water: std::pow costs as much as all
  /// neighbours of a particle.
  static double power(double a, double b) {
    if (b < 0 || b > 16 || b != std::floor(b)) return std::pow(a, b);
    double product = 1;
    for (int bits = static_cast<int>(b); bits > 0; bits /= 2, a *= a)
      if (bits % 2 == 1) product *= a;
    return product;
  }
};

}  // namespace clapotis
