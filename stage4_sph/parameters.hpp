#pragma once

#include "common/simulation/parameters.hpp"

/// The parameters of the scenes of stage 4, written once.
namespace clapotis::stage4 {

namespace detail {
/// A number that takes effect at the start.
inline Parameter number(std::string name, std::string symbol, std::string unit, double value,
                        Range range = positive) {
  return {.name = std::move(name),
          .symbol = std::move(symbol),
          .unit = std::move(unit),
          .value = value,
          .range = range,
          .change = Change::restart};
}
inline Parameter choice(std::string name, std::vector<std::string> choices) {
  return {.name = std::move(name),
          .symbol = "",
          .unit = "",
          .change = Change::restart,
          .choices = std::move(choices)};
}
}  // namespace detail

// geometry
inline const auto tank_width = detail::number("tank_width", "W", "L", 4);
inline const auto tank_height = detail::number("tank_height", "H_t", "L", 3);
inline const auto column_width = detail::number("column_width", "a", "L", 1);
inline const auto column_height = detail::number("column_height", "H", "L", 2);
inline const auto depth = detail::number("depth", "H", "L", 1);
inline const auto drop_radius = detail::number("radius", "R", "L", 1);
inline const auto patch_side = detail::number("side", "L", "L", 1);

// motion at the start
inline const auto strain_rate = detail::number("strain_rate", "A0", "1/s", 1);
inline const auto angular_speed = detail::number("angular_speed", "omega", "1/s", 1);
inline const auto impact_speed = detail::number("impact_speed", "U", "L/s", 2, not_negative);
inline const auto drop_height = detail::number("drop_height", "h_d", "L", 0.2, not_negative);
inline const auto disturbance = detail::number("disturbance", "", "", 1e-4, {.low = 0, .high = 0.5});
inline const auto disturbance_seed = detail::number("seed", "", "", 1, {.low = 0, .high = 0x1p53});

// the liquid
inline const auto formulation = detail::choice("formulation", {"consistent"});
inline const auto particle_spacing = detail::number("spacing", "dx", "L", 0.03125);
inline const auto h_over_dx = detail::number("h_over_dx", "h/dx", "", 1.5, {.low = 0.5, .high = 4});
inline const auto kernel_choice = detail::choice("kernel", {"cubic_spline", "wendland_c2"});
inline const auto density_form = detail::choice("density", {"continuity", "summation"});
inline const auto wall_form = detail::choice("walls", {"dummy", "reflect"});
inline const auto reference_density = detail::number("reference_density", "rho_0", "kg/L^3", 1000);
inline const auto sound_speed = detail::number("sound_speed", "c", "L/s", 10);
inline const auto polytropic_exponent = detail::number("gamma", "gamma", "", 7, {.low = 1, .high = 20});
inline const auto bears_tension = detail::choice("tension", {"no", "yes"});
inline const Parameter smoothing_length{.name = "smoothing_length", .symbol = "h", .unit = "L"};
inline const Parameter particle_mass{.name = "particle_mass", .symbol = "m", .unit = "kg/L"};
inline const auto kinematic_viscosity = detail::number("nu", "nu", "L^2/s", 0, not_negative);

}  // namespace clapotis::stage4
