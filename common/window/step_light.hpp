#pragma once

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// How near the time step is to losing the run: amber above 80 % of a limit of stability, red above all of
/// it.
struct StepLight {
  enum class Colour { calm, amber, red } colour = Colour::calm;
  StepLimit limit;   ///< the limit of stability in question, or else the limit that sets dt
  double share = 0;  ///< dt over it
};

StepLight step_light(const Simulation& simulation);

}  // namespace clapotis
