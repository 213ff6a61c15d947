#pragma once

#include <functional>

#include "common/particles/particles.hpp"
#include "common/simulation/parallel.hpp"

namespace clapotis {

class Model;

/// What an integrator advances: positions, velocities, and the energy the laws have dissipated, by the same
/// scheme. y points up. `acceleration` and `dissipation` are those of the last `evaluate`.
struct System {
  System(Particles start, Model& laws) : particles(std::move(start)), model(laws) {}

  Particles particles;
  Model& model;
  double time = 0;               ///< t [s]
  double dissipated_energy = 0;  ///< energy lost to laws and walls since the start [energy]
  double dissipation = 0;        ///< its rate, by the laws that act at every instant [energy/s]
  long force_evaluations = 0;
  bool current = false;  ///< whether acceleration and dissipation belong to the state as it stands
  /// Takes out of the acceleration what a wall bears; empty but for a particle that can rest on one.
  std::function<void(System&)> bear;

  Vectors& position = particles.position;
  Vectors& velocity = particles.velocity;
  Vectors& acceleration = particles.acceleration;

  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// target = expression, a block of rows at a time, shared between threads: the same bits with any number of
  /// them.
  template <class Expression>
  void assign(Vectors& target, const Eigen::ArrayBase<Expression>& expression) const {
    target.resize(expression.rows(), 2);
    for_blocks(expression.rows(), threads(), [&](Index first, Index count) {
      target.middleRows(first, count) = expression.derived().middleRows(first, count);
    });
  }
  [[nodiscard]] int threads() const;

  /// Fills acceleration and dissipation from positions and velocities, at time t.
  void evaluate(double t);
};

}  // namespace clapotis
