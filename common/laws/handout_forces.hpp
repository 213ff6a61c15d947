#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// +1 where the unit vector of section VI points from j to i, as its formulas need; -1 where it points from i
/// to j, as section IV defines it and section VI does not take back. Erratum 3 and 4 of this project's list.
inline double orientation(Parameters& p) {
  const auto signs = p.choice({.name = "signs",
                               .symbol = "",
                               .unit = "",
                               .change = Change::restart,
                               .choices = {"consistent", "printed"}});
  return signs == "consistent" ? 1 : -1;
}

/// Pressure force of the handout, section VI: f_i = -m_i sum_j m_j (P_i/rho_i^2 + P_j/rho_j^2) W' u.
struct HandoutPressure {
  static constexpr std::string_view name = "pressure";
  double sign;

  static HandoutPressure from(Parameters& p) { return {orientation(p)}; }
  auto stress(const auto& i, const auto& j, const Meeting& /*ij*/) const {
    return -sign * i.density * j.density *
           (i.pressure / (i.density * i.density) + j.pressure / (j.density * j.density));
  }
};
static_assert(Law<HandoutPressure> && ActsByStress<HandoutPressure>);

/// Viscosity as printed, section VI: f_i = m_i sum_j m_j alpha h c (rho_i + rho_j)/2 (v_ij.u) W' u where
/// v_ij.u < 0. Its dimension is not that of a force (erratum 5).
struct PrintedViscosity {
  static constexpr std::string_view name = "viscosity";
  static constexpr bool dissipates = true;
  double sign, strength;

  static PrintedViscosity from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const double alpha = p.number(handout_alpha);
    return {orientation(p), alpha * fluid.h * fluid.state.sound_speed};
  }
  auto stress(const auto& i, const auto& j, const Meeting& ij) const {
    const auto meeting = sign * min(sign * ij.approach, 0.0) * ij.inverse_distance;  // v_ij.u, from j to i
    return i.density * j.density * strength * 0.5 * (i.density + j.density) * meeting;
  }
  inline static const Parameter handout_alpha{
      .name = "alpha", .symbol = "alpha", .unit = "", .value = 0.1, .range = not_negative};
};
static_assert(Law<PrintedViscosity> && ActsByStress<PrintedViscosity>);

/// The same as Monaghan 1992 has it: a_i = sum_j m_j alpha c mu/rho_mean grad W, mu = h v_ij.d/(r^2 + 0.01
/// h^2) where v_ij.d < 0.
struct MonaghanViscosity {
  static constexpr std::string_view name = "viscosity";
  static constexpr bool dissipates = true;
  double sign, strength, h;

  static MonaghanViscosity from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const double alpha = p.number(PrintedViscosity::handout_alpha);
    return {orientation(p), alpha * fluid.h * fluid.state.sound_speed, fluid.h};
  }
  auto stress(const auto& i, const auto& j, const Meeting& ij) const {
    const auto r2 = dot(ij.separation, ij.separation);
    const auto mu = sign * min(sign * ij.approach, 0.0) / (r2 + 0.01 * h * h);
    return i.density * j.density * strength * mu * 2.0 / (i.density + j.density);
  }
};
static_assert(Law<MonaghanViscosity> && ActsByStress<MonaghanViscosity>);

}  // namespace clapotis
