#pragma once

#include "common/laws/fluid.hpp"
#include "common/simulation/system.hpp"

namespace clapotis {

/// Energies per unit depth. In scenes without pixels: joule per metre; in pixels kg px^2/s^2.
struct Energy {
  double kinetic = 0;     ///< sum m v^2/2
  double potential = 0;   ///< of the weight, and of a liquid's surface
  double elastic = 0;     ///< of the springs
  double internal = 0;    ///< of the compression of a fluid
  double dissipated = 0;  ///< lost to laws and walls so far, advanced by the same scheme as the state

  /// What falls in a dissipative system.
  [[nodiscard]] double mechanical() const { return kinetic + potential + elastic + internal; }
  /// What stays: its drift is the error of the scheme.
  [[nodiscard]] double total() const { return mechanical() + dissipated; }
};

Energy energy(System& system);

Vector momentum(const Particles& particles);        ///< sum m v
Vector centre_of_mass(const Particles& particles);  ///< sum m r / sum m
double max_speed(const Particles& particles);       ///< NaN if any speed is

/// Root mean square of rho/rho_0 - 1 over the particles of a fluid.
double density_error(const Particles& particles, const Fluid& fluid);

}  // namespace clapotis
