#pragma once

#include "common/laws/law.hpp"

namespace clapotis {

/// What drives a liquid along a channel: a = f e_x, in place of a gradient of pressure that a periodic
/// channel cannot have. It is no field: walls along the channel do not bear it.
struct DrivingForce {
  static constexpr std::string_view name = "driving_force";
  double f;  ///< [L/s^2]

  static DrivingForce from(Parameters& p) {
    return {p.number({.name = "driving", .symbol = "f", .unit = "L/s^2", .value = 1e-4})};
  }
  Vector body(const auto& /*p*/, Index /*i*/, double /*t*/) const { return {f, 0}; }
  double dissipation(const auto& p, Index i, double /*t*/) const { return -p.mass(i) * f * p.velocity(i).x; }
};
static_assert(Law<DrivingForce> && ActsOnBody<DrivingForce> && Dissipates<DrivingForce>);

}  // namespace clapotis
