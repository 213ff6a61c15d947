#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Symplectic (semi-implicit) Euler: the new position from the NEW velocity. Order 1; an oscillator keeps its
/// energy on average for w dt < 2. One line away from the printed one, for the same price.
class SymplecticEuler final : public Integrator {
 public:
  void step(System& s, double dt) override {
    s.assign(s.velocity, s.velocity + dt * s.acceleration);
    s.drift(dt);
    s.dissipated_energy += dt * s.dissipation;
  }
};

}  // namespace clapotis
