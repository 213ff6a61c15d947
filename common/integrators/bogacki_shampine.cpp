#include "common/integrators/bogacki_shampine.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {
namespace {

constexpr double safety = 0.9, most_growth = 5, most_cut = 0.2;
constexpr double shortest = 1e-6;  // of dt: what no step is short enough for is a jump, and is passed

/// Greatest of |error|/(1 + |y|); not a number where one of them is none.
double greatest(const Vectors& error, const Vectors& y) {
  return (error.abs() / (1 + y.abs())).maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace

void BogackiShampine::step(System& s, double dt) {
  double trial = dt;
  for (double left = dt; left > 0;) {
    remember(s);
    double tried = 0, error = 0;
    do {
      tried = trial < left * (1 - 1e-12) ? trial : left;
      error = attempt(s, s.time + (dt - left), tried);
      // the error of order 2 goes with the third power of the step
      const double factor = std::isfinite(error) ? safety / std::cbrt(error) : most_cut;
      trial = std::max(tried * std::clamp(factor, most_cut, most_growth), shortest * dt);
    } while (!(error <= 1) && tried > shortest * dt);
    if (!std::isfinite(error)) return;  // there is no way on, as the engine will see
    left = tried < left ? left - tried : 0;
  }
}

void BogackiShampine::remember(const System& s) {
  s.assign(x0_, s.position, v0_, s.velocity, a0_, s.acceleration);
  power0_ = s.dissipation;
  dissipated0_ = s.dissipated_energy;
}

/// k_1 = f(t, y), k_2 = f(t + dt/2, y + dt/2 k_1), k_3 = f(t + 3 dt/4, y + 3 dt/4 k_2), k_4 = f(t + dt, y_3):
///   y_3 = y + dt (2/9 k_1 + 1/3 k_2 + 4/9 k_3),   y_3 - y_2 = dt (-5/72 k_1 + 1/12 k_2 + 1/9 k_3 - 1/8 k_4).
double BogackiShampine::attempt(System& s, double t, double dt) {
  s.dissipated_energy = dissipated0_ + dt * 2 / 9 * power0_;
  s.assign(x_, x0_ + dt * 2 / 9 * v0_, v_, v0_ + dt * 2 / 9 * a0_,      //
           x_error_, dt * -5 / 72 * v0_, v_error_, dt * -5 / 72 * a0_,  //
           s.position, x0_ + dt / 2 * v0_, s.velocity, v0_ + dt / 2 * a0_);
  s.evaluate(t + dt / 2);
  s.dissipated_energy += dt / 3 * s.dissipation;
  s.assign(x_, x_ + dt / 3 * s.velocity, v_, v_ + dt / 3 * s.acceleration,  //
           x_error_, x_error_ + dt / 12 * s.velocity, v_error_, v_error_ + dt / 12 * s.acceleration,
           s.position, x0_ + dt * 3 / 4 * s.velocity, s.velocity, v0_ + dt * 3 / 4 * s.acceleration);
  s.evaluate(t + dt * 3 / 4);
  s.dissipated_energy += dt * 4 / 9 * s.dissipation;
  s.assign(x_error_, x_error_ + dt / 9 * s.velocity, v_error_, v_error_ + dt / 9 * s.acceleration, s.position,
           x_ + dt * 4 / 9 * s.velocity, s.velocity, v_ + dt * 4 / 9 * s.acceleration);
  s.evaluate(t + dt);
  s.assign(x_error_, x_error_ - dt / 8 * s.velocity, v_error_, v_error_ - dt / 8 * s.acceleration);
  return std::max(greatest(x_error_, s.position), greatest(v_error_, s.velocity)) / tolerance_;
}

}  // namespace clapotis
