#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Runge-Kutta 2, midpoint (Runge 1895). Order 2, two evaluations per step; an undamped oscillator slowly
/// gains energy, (w dt)^4/4 of it each step.
class Rk2 final : public Integrator {
 public:
  void step(System& s, double dt) override {
    x0_ = s.position;
    v0_ = s.velocity;
    s.position += dt / 2 * v0_;
    s.velocity += dt / 2 * s.acceleration;
    s.evaluate(s.time + dt / 2);
    s.position = x0_ + dt * s.velocity;
    s.velocity = v0_ + dt * s.acceleration;
    s.dissipated_energy += dt * s.dissipation;
  }

 private:
  Vectors x0_, v0_;
};

}  // namespace clapotis
