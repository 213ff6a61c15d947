#pragma once

#include <string_view>

#include "common/simulation/parameters.hpp"

namespace clapotis {

/// A number that an option takes; throws BadInput with name, value and range.
inline double option_number(std::string_view name, std::string_view text, Range range,
                            const char* unit = "s") {
  return Parameter{.name = std::string(name), .symbol = {}, .unit = unit, .range = range}.parse(text);
}

inline long option_count(std::string_view name, std::string_view text, Range range) {
  const Parameter p{.name = std::string(name), .symbol = {}, .unit = {}, .range = range, .integer = true};
  return static_cast<long>(p.parse(text));
}

inline constexpr Range thread_range{.low = 1, .high = 1024}, step_range{.low = 0, .high = 1e15};

/// `until`, or BadInput for a time that no loop in steps of dt would ever arrive at, nor t = k dt resolve.
double reachable(double until, double dt);

}  // namespace clapotis
