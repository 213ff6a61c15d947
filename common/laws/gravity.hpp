#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// Weight: a = -g e_y, with potential energy m g y. Handout, section III.
struct Gravity {
  static constexpr std::string_view name = "gravity";
  double g;  ///< [L/s^2], >= 0

  static Parameter parameter() {
    return {.name = "gravity", .symbol = "g", .unit = "L/s^2", .value = 9.81, .range = not_negative};
  }
  static Gravity from(Parameters& p) { return {p.number(parameter())}; }
  Vector field(const Vector& /*r*/, double /*t*/) const { return {0, -g}; }
  double potential(const auto& p, Index i) const { return p.mass(i) * g * p.position(i).y; }
};
static_assert(Law<Gravity> && ActsAsField<Gravity> && StoresPotential<Gravity>);

}  // namespace clapotis
