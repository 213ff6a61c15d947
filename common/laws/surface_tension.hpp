#pragma once

#include <cmath>
#include <numbers>

#include "common/kernels/wendland_c2.hpp"
#include "common/laws/law.hpp"
#include "common/simulation/model.hpp"

namespace clapotis {

/// Surface tension of a liquid alone, without the gas around it: near particles push each other apart,
/// farther ones attract, and at the surface attraction is missing on one side. With s = r/(2h),
///
///   f_i = V_i sum_j V_j A (rho_i rho_j/rho_0^2) (1-s)^2 (33 s^2 - 10 s - 2) d W'/r,   W Wendland's C2,
///
/// which is the slope of the pair energy u = -B lap w, w = (1-s)^8 (1 + 8 s + 25 s^2 + 32 s^3): the Laplacian
/// of Wendland's C6 kernel. So
/// - u depends on the places alone: its sum over pairs is the energy of the surface;
/// - its integral over the plane is 0: a liquid without surface feels no pressure of it;
/// - its Fourier transform, B k^2 w^, is nowhere negative: particles do not pair;
/// - w^ falls so fast that the lattice is hardly felt, for a liquid must not resist shear as a crystal does.
///   From h/dx = 2.5 on a shear costs less than 0.02 sigma/h, with h/dx = 2 five times as much.
/// The idea of forces between pairs is that of Tartakovsky & Meakin 2005, Phys. Rev. E 72.
///
/// A follows from sigma: see `tension_of_flat_surface`. A wall of particles repels as the liquid does and
/// attracts with the share `wetting` of it, see `wetting_for`.
///
/// The density must not diffuse (delta = 0): below a surface the pressure is uneven, and what flattens it
/// lets the tension sink.
struct SurfaceTension {
  static constexpr std::string_view name = "surface_tension";
  double sigma;                ///< [kg/s^2], per unit of depth
  double h;                    ///< smoothing length [L]
  double strength;             ///< A/rho_0^2 [L^5/(kg s^2)]
  double wetting;              ///< share of attraction of the walls
  double reference_density;    ///< rho_0 [kg/L^3]
  double pair_energy_at_zero;  ///< u(0) of two particles [energy]
  double energy_of_bulk;       ///< of one particle inside the liquid, itself included [energy]

  static Parameter parameter() {
    return {.name = "sigma",
            .symbol = "sigma",
            .unit = "kg/s^2",
            .value = 0.072,
            .range = positive,
            .change = Change::restart};
  }
  /// The angle between plate and surface, inside the liquid. A scene without walls does not state it.
  static Parameter angle_parameter() {
    return {.name = "contact_angle",
            .symbol = "theta",
            .unit = "deg",
            .value = 90,
            .range = {.low = 45, .high = 135},
            .change = Change::restart};
  }
  static SurfaceTension from(Parameters& p);

  [[gnu::always_inline]] static auto profile(const auto& s) {
    const auto rest = 1.0 - s;
    return rest * rest * ((33.0 * s - 10.0) * s - 2.0);
  }
  [[gnu::always_inline]] auto stress_at(const auto& r, const auto& i, const auto& j) const {
    return strength * (i.density * j.density) * profile(r * (0.5 / h));
  }
  [[gnu::always_inline]] auto stress(const auto& i, const auto& j, const Meeting& ij) const {
    return stress_at(dot(ij.separation, ij.separation) * ij.inverse_distance, i, j);
  }
  [[gnu::always_inline]] auto wall_stress(const auto& i, const auto& j, const Meeting& ij) const {
    const auto as_liquid = stress(i, j, ij);
    return min(as_liquid, 0.0) + wetting * max(as_liquid, 0.0);
  }
  /// u(r) of two particles [energy].
  [[gnu::always_inline]] auto pair_energy(const auto& r) const {
    const auto s = r * (0.5 / h), rest = max(1.0 - s, 0.0), cube = rest * rest * rest;
    return pair_energy_at_zero * (cube * cube) * (1.0 + s * (6.0 - s * (3.0 + 88.0 * s)));
  }
  /// What a particle has less than inside the liquid is the energy of the surface.
  double potential(const auto& /*p*/, Index /*i*/) const { return -energy_of_bulk; }

  /// The shortest waves that the particles show, of length h, move less than their length in a step.
  /// Brackbill, Kothe & Zemach 1992, J. Comput. Phys. 100.
  [[nodiscard]] StepLimit limit(const Particles& /*particles*/) const {
    return {.name = "capillary",
            .formula = "sqrt(rho_0 h^3/(2 pi sigma))",
            .limit = std::sqrt(reference_density * h * h * h / (2 * std::numbers::pi * sigma)),
            .share = 0.25,
            .stability = false};
  }

  /// sigma/(A h) of a flat surface. The forces between pairs alone would give 0.0225 with uniform density,
  /// but they do not balance at each depth: a pressure builds up in the liquid's skin until they do, negative
  /// outside, and it pulls along the surface too. Here the particles of a hexagonal lattice fill a
  /// half-plane; each row has the pressure that holds it in place, and sigma is the sum over all pairs of the
  /// forces' normal less tangential part (Kirkwood & Buff 1949). 0.0332 for h/dx to infinity, 0.0326 for 3,
  /// 0.0303 for 2.
  static double tension_of_flat_surface(double h_over_dx);

  /// The share of attraction of a wall that the liquid meets at `angle` [rad]. By Young and Dupre the wall's
  /// work of adhesion is sigma (1 + cos theta), and it grows linearly with the share; how much of it
  /// repulsion and the pressure beside the wall take off is measured, not derived: drops that came to rest on
  /// plates with shares from -0.08 to 0.7, of R/dx = 12 to 30.
  static double wetting_for(double angle) {
    const double c = std::cos(angle);
    return 0.22 + c * (0.45 + c * 0.10);
  }
};
static_assert(Law<SurfaceTension> && StressesWalls<SurfaceTension> && StoresBetweenParticles<SurfaceTension>);

}  // namespace clapotis
