#pragma once

#include "common/runner/options.hpp"

namespace clapotis::testing {

// A session that is played without a window.

inline constexpr double plenty = 1e9;      ///< s of work allowed: never the reason to stop
inline constexpr double frame = 1 / 60.0;  ///< s

inline Options options_of(const std::string& scene, const Overrides& parameters = {},
                          const std::string& integrator = std::string(default_integrator)) {
  Options options;
  options.scene.value = scene;
  options.parameters = parameters;
  options.integrator.value = integrator;
  return options;
}

}  // namespace clapotis::testing
