#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// Pressure force that goes with the equation of continuity: f_i = -V_i sum_j V_j (p_i + p_j) grad W. What
/// the particles lose in speed is what their compression stores, to the last digit. Bonet & Lok 1999;
/// Colagrossi & Landrini 2003.
struct PressureForce {
  static constexpr std::string_view name = "pressure";
  static PressureForce from(Parameters& /*p*/) { return {}; }

  auto stress(const auto& i, const auto& j, const Meeting& /*ij*/) const {
    return -(i.pressure + j.pressure);
  }
  auto wall_stress(const auto& i, const auto& j, const Meeting& ij) const { return stress(i, j, ij); }
};
static_assert(Law<PressureForce> && ActsByStress<PressureForce> && StressesWalls<PressureForce>);

/// Pressure force that goes with the sum of densities, rho_i = sum_j m W: it follows from that sum and the
/// energy of compression, f_i = -sum_j m^2 (p_i/rho_i^2 + p_j/rho_j^2) grad W. Handout, section VI and annexe
/// 2, with d from j to i; Monaghan 1992.
struct SummationPressureForce {
  static constexpr std::string_view name = "pressure";
  static SummationPressureForce from(Parameters& /*p*/) { return {}; }

  auto stress(const auto& i, const auto& j, const Meeting& /*ij*/) const {
    const auto mass = i.density * i.volume;
    return -1 / mass * (i.pressure * i.volume * j.density + j.pressure * j.volume * i.density);
  }
  auto wall_stress(const auto& i, const auto& j, const Meeting& ij) const { return stress(i, j, ij); }
};
static_assert(Law<SummationPressureForce> && ActsByStress<SummationPressureForce>);

}  // namespace clapotis
