#pragma once

#include "common/laws/fluid.hpp"

/// What the laws of a fluid give for a particle and a pack of others, summed over the laws: one that lacks a
/// hook adds nothing, and a sum of which none acts generates no code.
namespace clapotis::hooks {

/// Nothing to add.
struct None {};
template <class T>
[[gnu::always_inline]] inline T operator+(None /*nothing*/, const T& a) {
  return a;
}
template <class T>
[[gnu::always_inline]] inline T operator+(const T& a, None /*nothing*/) {
  return a;
}
inline None operator+(None /*a*/, None /*b*/) { return {}; }

template <class L>
inline constexpr bool takes_energy = requires {
  requires L::dissipates;
};

// One law in a sum; None where it has no such hook.
template <class L>
auto stress(const L& law, const auto& i, const auto& j, const Meeting& ij) {
  if constexpr (ActsByStress<L>)
    return Pack(law.stress(i, j, ij));
  else
    return None{};
}
template <class L>
auto friction(const L& law, const auto& i, const auto& j, const Meeting& ij) {
  if constexpr (ActsByFriction<L>)
    return Pack(law.friction(i, j, ij));
  else
    return None{};
}
template <class L>
auto wall_stress(const L& law, const auto& i, const auto& j, const Meeting& ij) {
  if constexpr (StressesWalls<L>)
    return Pack(law.wall_stress(i, j, ij));
  else
    return None{};
}
template <class L>
auto wall_friction(const L& law, const auto& i, const auto& j, const Meeting& ij) {
  if constexpr (RubsWalls<L>)
    return Pack(law.wall_friction(i, j, ij));
  else
    return None{};
}
/// What the pair's forces do to its motion, for the laws that take energy out of it.
template <class L>
auto loss(const L& law, const auto& i, const auto& j, const Meeting& ij, const Vec<Pack>& v) {
  if constexpr (!takes_energy<L>)
    return None{};
  else if constexpr (ActsByStress<L>)
    return Pack(law.stress(i, j, ij) * ij.approach);
  else
    return Pack(law.friction(i, j, ij) * dot(v, v));
}

inline void add(Vec<Pack>& /*sum*/, const Pack& /*weight*/, None /*nothing*/, const Vec<Pack>& /*along*/) {}
inline void add(Vec<Pack>& sum, const Pack& weight, const Pack& strength, const Vec<Pack>& along) {
  sum += (weight * strength) * along;
}
inline void add(Pack& /*sum*/, const Pack& /*weight*/, None /*nothing*/) {}
inline void add(Pack& sum, const Pack& weight, const Pack& strength) { sum += weight * strength; }

}  // namespace clapotis::hooks
