#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Runge-Kutta 4 (Kutta 1901). Order 4, four evaluations per step; stable for w dt < 2.828.
class Rk4 final : public Integrator {
 public:
  void step(System& s, double dt) override {
    x0_ = s.position;
    v0_ = s.velocity;
    rho0_ = s.density;
    s.evaluate_density_rate();
    v_ = v0_;
    a_ = s.acceleration;
    rate_ = s.density_rate;
    double power = s.dissipation + s.diffusion;
    const auto stage = [&](double c, double weight) {
      go(s, c * dt, s.velocity, s.acceleration, s.density_rate);
      s.evaluate(s.time + c * dt);
      s.evaluate_density_rate();
      v_ += weight * s.velocity;
      a_ += weight * s.acceleration;
      rate_ += weight * s.density_rate;
      power += weight * (s.dissipation + s.diffusion);
    };
    stage(0.5, 2);
    stage(0.5, 2);
    stage(1.0, 1);
    go(s, dt / 6, v_, a_, rate_);
    s.dissipated_energy += dt / 6 * power;
  }

 private:
  /// From the start of the step, for dt, at these rates of position, velocity and density.
  void go(System& s, double dt, const Vectors& v, const Vectors& a, const Column& rate) const {
    s.position = x0_ + dt * v;
    s.velocity = v0_ + dt * a;
    if (s.advances_density()) s.density = rho0_ + dt * rate;
  }

  Vectors x0_, v0_, v_, a_;
  Column rho0_, rate_;
};

}  // namespace clapotis
