#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Velocity Verlet (Verlet 1967, Swope et al. 1982): kick, drift, kick. Order 2, symplectic for forces of
/// position alone, stable for w dt < 2, one evaluation per step. The velocity is predicted before the
/// evaluation, for forces that depend on it: this keeps order 2 with drag. A density that follows from the
/// equation of continuity drifts with the position.
class VelocityVerlet final : public Integrator {
 public:
  void step(System& s, double dt) override {
    s.assign(s.velocity, s.velocity + dt / 2 * s.acceleration);
    s.drift(dt);
    s.assign(half_, s.velocity, s.velocity, s.velocity + dt / 2 * s.acceleration);
    s.dissipated_energy += dt / 2 * s.dissipation;
    s.evaluate(s.time + dt);
    s.assign(s.velocity, half_ + dt / 2 * s.acceleration);
    s.dissipated_energy += dt / 2 * s.dissipation;
  }
  [[nodiscard]] bool leaves_acceleration() const override { return true; }

 private:
  Vectors half_;
};

}  // namespace clapotis
