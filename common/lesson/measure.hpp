#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/simulation/simulation.hpp"

namespace clapotis {

struct Measured {
  double value = 0;
  std::string unit;  ///< "1" of a pure number
};

/// What a check may ask of a run as it stands: a column of series.csv that says something about one instant,
/// the error and the scene's own measures among them, or `steps`, `force_evaluations`, `pairs_tested`,
/// `pairs_near`. Nothing when the scene has no such quantity.
std::optional<Measured> measure(std::string_view quantity, Simulation& simulation);

/// A check may also ask at which step a run diverged.
inline constexpr std::string_view diverged_step = "diverged_step";

}  // namespace clapotis
