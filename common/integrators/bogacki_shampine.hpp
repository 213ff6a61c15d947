#pragma once

#include "common/integrators/integrator.hpp"
#include "common/simulation/parameters.hpp"

namespace clapotis {

/// What an adaptive scheme may err by in one of its steps, in any coordinate [L] or velocity [L/s] y:
/// tolerance (1 + |y|).
inline const Parameter tolerance_parameter{
    .name = "tolerance", .symbol = "tol", .unit = "", .value = 1e-6, .range = {.low = 1e-12, .high = 1}};

/// Embedded pair of Runge-Kutta schemes of orders 3 and 2 (Bogacki & Shampine 1989). The difference of the
/// two is the error of the lower one; as long as it is beyond the tolerance, the step is tried again,
/// shorter, and the higher order goes on. So dt is the longest step: it is cut into as many as the tolerance
/// asks for, three evaluations each. Nothing is remembered from one dt to the next, whose first trial is
/// again all of it: the same state and dt give the same bits.
class BogackiShampine final : public Integrator {
 public:
  void step(System& s, double dt) override;
  [[nodiscard]] bool leaves_acceleration() const override {
    return true;
  }  // the last stage is the next first
  [[nodiscard]] bool controls_error() const override { return true; }
  void read(Parameters& p) override { tolerance_ = p.number(tolerance_parameter); }

 private:
  /// From the start of the trial, all four stages at time t; returns the error over the tolerance.
  double attempt(System& s, double t, double dt);
  void remember(const System& s);

  double tolerance_ = tolerance_parameter.value;
  Vectors x0_, v0_, a0_;                 ///< at the start of a trial
  double power0_ = 0, dissipated0_ = 0;  ///< dissipation and dissipated energy there
  Vectors x_, v_;                        ///< of order 3, as they are summed up
  Vectors x_error_, v_error_;            ///< of order 3 less that of order 2
};

}  // namespace clapotis
