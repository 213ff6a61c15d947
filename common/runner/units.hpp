#pragma once

#include <string>
#include <string_view>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// `unit` with the scene's unit of length in the place of L.
std::string with_length(std::string_view unit, std::string_view length_unit);

// A particle of a fluid has its mass per unit of depth, kg/L; so have its energy, momentum and force.
std::string energy_unit(const Simulation& simulation);    ///< kg L^2/s^2, in a fluid kg L/s^2
std::string momentum_unit(const Simulation& simulation);  ///< kg L/s, in a fluid kg/s

// The same where a person reads: with names where the scene is in metres.
std::string short_energy_unit(const Simulation& simulation);  ///< J, J/m, kg px^2/s^2, ...
std::string short_force_unit(const Simulation& simulation);   ///< N, N/m, kg px/s^2, ...
/// In the place of L the unit of length; Pa for kg/(m s^2).
std::string short_unit(std::string_view unit, std::string_view length_unit);
/// With raised figures: m/s², kg/m³.
std::string printed(std::string unit);

}  // namespace clapotis
