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
    rho0_ = s.density;
    s.evaluate_density_rate();
    go(s, dt / 2);
    s.evaluate(s.time + dt / 2);
    s.evaluate_density_rate();
    go(s, dt);
    s.dissipated_energy += dt * (s.dissipation + s.diffusion);
  }

 private:
  /// From the start of the step, for dt, at the rates as they stand.
  void go(System& s, double dt) const {
    s.position = x0_ + dt * s.velocity;
    s.velocity = v0_ + dt * s.acceleration;
    if (s.advances_density()) s.density = rho0_ + dt * s.density_rate;
  }

  Vectors x0_, v0_;
  Column rho0_;
};

}  // namespace clapotis
