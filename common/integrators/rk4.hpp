#pragma once

#include "common/integrators/integrator.hpp"

namespace clapotis {

/// Runge-Kutta 4 (Kutta 1901). Order 4, four evaluations per step; stable for w dt < 2.828.
class Rk4 final : public Integrator {
 public:
  void step(System& s, double dt) override {
    x0_ = s.position;
    v0_ = s.velocity;
    v_ = v0_;
    a_ = s.acceleration;
    double power = s.dissipation;
    const auto stage = [&](double c, double weight) {
      s.position = x0_ + c * dt * s.velocity;
      s.velocity = v0_ + c * dt * s.acceleration;
      s.evaluate(s.time + c * dt);
      v_ += weight * s.velocity;
      a_ += weight * s.acceleration;
      power += weight * s.dissipation;
    };
    stage(0.5, 2);
    stage(0.5, 2);
    stage(1.0, 1);
    s.position = x0_ + dt / 6 * v_;
    s.velocity = v0_ + dt / 6 * a_;
    s.dissipated_energy += dt / 6 * power;
  }

 private:
  Vectors x0_, v0_, v_, a_;
};

}  // namespace clapotis
