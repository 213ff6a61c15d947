#pragma once

#include <functional>

#include "common/particles/parallel.hpp"
#include "common/particles/particles.hpp"

namespace clapotis {

class Model;

/// What an integrator advances: positions, velocities, the density where it follows from the equation of
/// continuity, and the energy the laws have dissipated, by the same scheme. y points up. `acceleration` and
/// `dissipation` are those of the last `evaluate`.
struct System {
  System(Particles start, Model& laws) : particles(std::move(start)), model(laws) {}

  Particles particles;
  Model& model;
  double time = 0;               ///< t [s]
  double dissipated_energy = 0;  ///< energy lost to laws and walls since the start [energy]
  double dissipation = 0;        ///< its rate, by the laws that act at every instant [energy/s]
  double diffusion = 0;  ///< its rate by the diffusion of density, at the last `evaluate_density_rate`
  long force_evaluations = 0;
  long entered = 0, left = 0;  ///< particles, through inlets and outlets, since the start
  bool current = false;        ///< whether acceleration and dissipation belong to the state as it stands
  /// Takes out of the acceleration what a wall bears; empty but for a particle that can rest on one.
  std::function<void(System&)> bear;

  Vectors& position = particles.position;
  Vectors& velocity = particles.velocity;
  Vectors& acceleration = particles.acceleration;
  Column& density = particles.density;
  Column& density_rate = particles.density_rate;

  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// target = expression, then the next pair of them, row by row, shared between threads: the same bits with
  /// any number of them.
  template <class Target, class Expression, class... More>
  void assign(Target& target, const Expression& expression, More&&... more) const {
    const Index n = expression.rows();
    resize(n, target, expression, more...);
    for_rows(n, threads_for_little(n, particles.threads),
             [&](Index first, Index count) { assign_rows(first, count, target, expression, more...); });
  }

  /// Fills acceleration and dissipation from positions, velocities and densities, at time t.
  void evaluate(double t);

  /// Whether the density is part of the state, as the position is.
  [[nodiscard]] bool advances_density() const { return density_rate.size() > 0; }
  /// Fills density_rate and diffusion from positions, velocities and densities, where the density advances.
  void evaluate_density_rate();

  /// Moves with the velocity as it stands: x += dt v, and the density along the way, d rho/dt at its middle.
  void drift(double dt);

 private:
  static void resize(Index /*n*/) {}
  static void resize(Index n, auto& target, const auto& expression, auto&... more) {
    target.resize(n, expression.cols());
    resize(n, more...);
  }
  static void assign_rows(Index /*first*/, Index /*count*/) {}
  static void assign_rows(Index first, Index count, auto& target, const auto& expression, auto&... more) {
    target.middleRows(first, count) = expression.middleRows(first, count);
    assign_rows(first, count, more...);
  }
};

}  // namespace clapotis
