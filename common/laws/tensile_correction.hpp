#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// What keeps a liquid under tension from clumping: neighbours nearer than the spacing of the lattice push
/// each other apart in proportion to the tension, f_i = -V_i sum_j V_j epsilon (max(-p_i, 0) + max(-p_j, 0))
/// (W/W(dx))^4 grad W. Monaghan 2000, J. Comput. Phys. 159.
template <class Kernel>
struct TensileCorrection {
  static constexpr std::string_view name = "tensile_correction";
  static constexpr bool dissipates = true;  ///< its work, of either sign, is stored nowhere
  double epsilon;                           ///< >= 0
  Kernel kernel;
  double inverse_value;  ///< 1/W(dx) [L^2]

  static TensileCorrection from(Parameters& p) {
    const auto fluid = Fluid::from(p);
    const Kernel kernel(fluid.h);
    return {
        p.number({.name = "epsilon", .symbol = "epsilon", .unit = "", .value = 0.2, .range = not_negative}),
        kernel, 1 / kernel.value(fluid.spacing)};
  }
  auto stress(const auto& i, const auto& j, const Meeting& ij) const {
    const auto nearness =
        kernel.value(dot(ij.separation, ij.separation) * ij.inverse_distance) * inverse_value;
    const auto square = nearness * nearness;
    return epsilon * (min(i.pressure, 0.0) + min(j.pressure, 0.0)) * (square * square);
  }
};

}  // namespace clapotis
