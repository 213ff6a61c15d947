#pragma once

#include "common/laws/cole_equation.hpp"
#include "common/particles/pack.hpp"
#include "common/simulation/parameters.hpp"

/// What a law between the particles of a fluid is.
///
/// It is a law (law.hpp) with one or both of these hooks, which together say the force on particle i:
///
///   f_i = V_i sum_j V_j [ stress(i, j, ij) d + friction(i, j, ij) v_ij ] W'/r,   V = m/rho, d = r_i - r_j
///
/// - `stress` [kg/(L s^2)]: along the line from j to i; negative pushes apart, since W' < 0
/// - `friction` [kg/(L s)]: along the difference of velocities
///
/// Each pair gets opposite forces as long as the hook is symmetric in i and j. i and j have velocity,
/// density, volume and pressure; those of j are packs, about which one cannot ask with `if`: use max, min,
/// select (pack.hpp). `wall_stress` and `wall_friction` are the same towards the particles of walls; a law
/// without them does not act there. A law that takes energy out of the motion says
/// `static constexpr bool dissipates = true`; one whose force is the slope of an energy of the pair's
/// distance states that as `pair_energy(r)` [energy], for two particles of the fluid, and each particle is
/// counted with itself too.
namespace clapotis {

/// A liquid, and how finely it is resolved.
struct Fluid {
  double spacing;  ///< dx, of the lattice it starts from [L]
  double h;        ///< smoothing length [L]
  double mass;     ///< m of a particle, per unit of depth [kg/L]
  ColeEquation state;

  /// From the parameters that the scene has stated: spacing, smoothing_length, particle_mass,
  /// reference_density, sound_speed, gamma, tension.
  static Fluid from(const Parameters& p) {
    return {.spacing = p.value("spacing"),
            .h = p.value("smoothing_length"),
            .mass = p.value("particle_mass"),
            .state = {.reference_density = p.value("reference_density"),
                      .sound_speed = p.value("sound_speed"),
                      .gamma = p.value("gamma"),
                      .tension = p.value("tension") != 0}};
  }
};

/// A particle of a fluid as a law sees it: one number, or a pack for as many particles.
template <class T>
struct FluidParticle {
  Vec<T> velocity;  ///< [L/s]
  T density;        ///< rho [kg/L^3]
  T volume;         ///< V = m/rho, per unit of depth [L^2]
  T pressure;       ///< [kg/(L s^2)]
};

/// Particle i and the particles j of a pack, nearer than the support.
struct Meeting {
  Vec<Pack> separation;   ///< d [L]
  Pack inverse_distance;  ///< 1/r [1/L]; a very large number for two at one point
  Pack approach;          ///< v_ij . d, negative when they approach [L^2/s]
};

template <class L>
concept ActsByStress = requires(const L& law, const FluidParticle<double>& i, const FluidParticle<Pack>& j,
                                const Meeting& ij) {
  Pack{law.stress(i, j, ij)};
};
template <class L>
concept ActsByFriction = requires(const L& law, const FluidParticle<double>& i, const FluidParticle<Pack>& j,
                                  const Meeting& ij) {
  Pack{law.friction(i, j, ij)};
};
template <class L>
concept StressesWalls = requires(const L& law, const FluidParticle<double>& i, const FluidParticle<Pack>& j,
                                 const Meeting& ij) {
  Pack{law.wall_stress(i, j, ij)};
};
template <class L>
concept RubsWalls = requires(const L& law, const FluidParticle<double>& i, const FluidParticle<Pack>& j,
                             const Meeting& ij) {
  Pack{law.wall_friction(i, j, ij)};
};
/// A law that acts with the velocities at the end of the step: `Implicit` (implicit.hpp).
template <class L>
concept ActsImplicitly = requires {
  requires L::implicit;
};
template <class L>
concept StoresBetweenParticles = requires(const L& law, const Pack& r) {
  Pack{law.pair_energy(r)};
};
template <class L>
concept FluidLaw = ActsByStress<L> || ActsByFriction<L> || StressesWalls<L> || RubsWalls<L>;

}  // namespace clapotis
