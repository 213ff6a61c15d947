#pragma once

#include <string_view>
#include <vector>

#include "common/laws/fluid.hpp"
#include "common/particles/pack.hpp"
#include "common/particles/particles.hpp"
#include "common/simulation/parameters.hpp"

/// What a law is.
///
/// A law is a small value type with a `name`, a function `from(Parameters&)` that reads its parameters, and
/// one or more of these hooks. A hook that it lacks generates no code.
///
/// - `Vector body(p, i, t)`: acceleration of particle i at time t [L/s^2]
/// - `Vector field(r, t)`: the same for whatever is at r: a liquid at rest in it presses on its walls [L/s^2]
/// - `Vec<Pack> pair(p, i, j, ij)`: acceleration of particle i by the particles j, zero at and beyond the
///   support [L/s^2]
/// - `double support()`: with `pair`, the distance beyond which nothing acts [L]
/// - `void settle(system, dt)`: after the step; the only place that may move a particle
/// - `double potential(p, i)`: energy stored by `body` [energy]
/// - `Pack pair_potential(p, i, j, ij)`: energy stored between i and each j [energy]
/// - `double dissipation(p, i, t)`: power that `body` or `field` takes out of the motion; negative if it
///   drives [energy/s]
/// - `StepLimit limit(particles)`: the largest stable time step
/// - `stress` and `friction`: between the particles of a fluid, see fluid.hpp
///
/// `p` gives p.position(i), p.velocity(i), p.mass(i). In `pair`, i is one particle and j is as many as a pack
/// holds, so p.mass(j) is a Pack, and a value of j cannot be asked about with `if`: use max, min, select
/// (pack.hpp).
namespace clapotis {

struct System;

/// As many particles as a pack holds, from `first` on, in the order of the sweep.
struct Run {
  Index first;
};

/// Particle i and the particles j of a pack. d = r_i - r_j points from j to i.
struct Encounter {
  Vec<Pack> separation;  ///< d [L]
  Pack distance;         ///< |d| [L]
  Vec<Pack> direction;   ///< u = d/|d|; for two particles at one point a fixed direction from their ids
};

inline double load(const double* column, Index i) { return column[i]; }
inline Pack load(const double* column, Run j) {
  return {column + j.first, std::experimental::element_aligned};
}

/// All particles of the scene have one mass.
struct UniformMass {
  UniformMass() = default;
  explicit UniformMass(const Particles& particles) : m(particles.uniform_mass) {}
  double m = 1;
  [[nodiscard]] double mass(auto /*i*/) const { return m; }
};

/// Each particle has its own mass, in the column "mass".
struct StoredMass {
  StoredMass() = default;
  explicit StoredMass(const Particles& particles) : m(particles.column("mass")->data()) {}
  const double* m = nullptr;
  [[nodiscard]] auto mass(auto i) const { return load(m, i); }
};

template <class>
inline constexpr bool never = false;

/// What a law sees of the particles. A pair law that reads velocities says so with
/// `static constexpr bool reads_velocity = true`, for they have to be brought along in the order of the
/// sweep.
template <class Mass, bool with_velocity>
struct View : Mass {
  const double *x = nullptr, *y = nullptr, *vx = nullptr, *vy = nullptr;

  [[nodiscard]] auto position(auto i) const { return Vec{load(x, i), load(y, i)}; }
  [[nodiscard]] auto velocity(auto i) const {
    if constexpr (with_velocity)
      return Vec{load(vx, i), load(vy, i)};
    else
      static_assert(never<decltype(i)>,
                    "This pair law reads velocities, which no law of the scene has asked for: write "
                    "`static constexpr bool reads_velocity = true;` in the law.");
  }
};

template <class Mass>
View<Mass, true> view_of(const Particles& p) {
  return {Mass(p), p.position.col(0).data(), p.position.col(1).data(), p.velocity.col(0).data(),
          p.velocity.col(1).data()};
}

using AnyView = View<UniformMass, true>;

template <class L>
concept ActsOnBody = requires(const L& law, const AnyView& p, Index i, double t) {
  Vector{law.body(p, i, t)};
};
template <class L>
concept ActsAsField = requires(const L& law, const Vector& r, double t) {
  Vector{law.field(r, t)};
};
template <class L>
concept ActsOnPair = requires(const L& law, const AnyView& p, Index i, Run j, const Encounter& ij) {
  Vec<Pack>{law.pair(p, i, j, ij)};
  double{law.support()};
};
template <class L>
concept Settles = requires(L& law, System& system, double dt) {
  law.settle(system, dt);
};
template <class L>
concept StoresPotential = requires(const L& law, const AnyView& p, Index i) {
  double{law.potential(p, i)};
};
template <class L>
concept StoresPairPotential = requires(const L& law, const AnyView& p, Index i, Run j, const Encounter& ij) {
  Pack{law.pair_potential(p, i, j, ij)};
};
template <class L>
concept Dissipates = requires(const L& law, const AnyView& p, Index i, double t) {
  double{law.dissipation(p, i, t)};
};
template <class L>
concept LimitsStep = requires(const L& law, const Particles& particles) {
  law.limit(particles);
};
/// A law whose limit changes with speeds or accelerations says `static constexpr bool follows_state = true`.
template <class L>
concept FollowsState = requires {
  requires L::follows_state;
};
template <class L>
concept ReadsVelocity = requires {
  requires L::reads_velocity;
};

template <class L>
concept ActsOnParticles =
    ActsOnBody<L> || ActsAsField<L> || ActsOnPair<L> || FluidLaw<L> || ActsImplicitly<L>;

template <class L>
concept Law = requires(Parameters& p) {
  { L::from(p) } -> std::same_as<L>;
  std::string_view{L::name};
}
&&(ActsOnParticles<L> || Settles<L> || LimitsStep<L>);

}  // namespace clapotis
