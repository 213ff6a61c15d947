#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Explicit Euler as the handout prints it (section III): the new velocity from the acceleration, the new
/// position from the OLD velocity. Order 1. Multiplies the energy of an oscillator by 1 + w^2 dt^2 each step:
/// unstable with springs at any dt.
class ExplicitEuler final : public Integrator {
 public:
  void step(System& s, double dt) override {
    s.evaluate_density_rate();
    s.assign(s.position, s.position + dt * s.velocity, s.velocity, s.velocity + dt * s.acceleration);
    if (s.advances_density()) s.assign(s.density, s.density + dt * s.density_rate);
    s.dissipated_energy += dt * (s.dissipation + s.diffusion);
  }
};

}  // namespace clapotis
