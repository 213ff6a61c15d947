#pragma once

#include <array>
#include <numbers>
#include <string_view>

namespace clapotis {

/// The largest step with which a scheme stays stable; 0: it grows at any step.
struct StabilityLimits {
  double explicit_euler;
  double symplectic_euler;  ///< and velocity Verlet
  double rk2;               ///< midpoint
  double rk4;
};

/// w dt of an undamped oscillator, theory: where the amplification of a step leaves the unit circle.
inline constexpr StabilityLimits oscillator_limits{0, 2, 0, 2 * std::numbers::sqrt2};

/// dt c/h of SPH with a density sum, and the set-up it was measured in.
struct SphStabilityLimits {
  std::string_view kernel;
  double h_over_dx;
  double alpha;  ///< artificial viscosity between approaching particles, Monaghan 1992
  StabilityLimits dt_c_over_h;
};

/// Measured for this project: 12 x 12 particles on a periodic square lattice, displaced at random by 1e-4 dx;
/// Cole equation with gamma = 7, rho0 the density sum of the lattice. Unstable is what multiplies its kinetic
/// energy by 1e4 in 1,200 steps (explicit Euler: 3,000); steps were tried 1.5 % apart. Symplectic Euler's and
/// RK4's are true limits. Those of explicit Euler and RK2 shrink as runs get longer: Euler's 0.074 at alpha =
/// 0.1 is 0.047 in 12,000 steps and 0.033 in 48,000.
inline constexpr std::array<SphStabilityLimits, 4> sph_stability_limits{
    {{"cubic_spline", 1.3, 0, {0, 1.88, 0, 2.64}},
     {"cubic_spline", 1.3, 0.1, {0.075, 1.85, 0.56, 2.72}},
     {"cubic_spline", 1.3, 1, {0.235, 1.48, 1.22, 2.56}},
     {"wendland_c2", 1.5, 0.1, {0.074, 1.74, 0.555, 2.56}}}};

}  // namespace clapotis
