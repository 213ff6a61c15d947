#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// What is not a finite number is null.
inline nlohmann::ordered_json or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json energy_json(const Energy& energy);

/// {name, measure, error (now), largest_error, unit, source}; null for a scene without a reference.
nlohmann::ordered_json reference_json(const Simulation& simulation, double largest_error);

}  // namespace clapotis
