#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "common/simulation/parameters.hpp"

namespace clapotis {

/// The origin written for a parameter that others determine: a replay does not set it.
inline constexpr std::string_view origin_of_results = "derived";

/// A number, or the word of a choice or of "auto".
nlohmann::ordered_json json_value(const Parameter& p);

/// {name: {value, unit, origin}} in the order of the scene.
nlohmann::ordered_json parameters_json(const Parameters& parameters);

}  // namespace clapotis
