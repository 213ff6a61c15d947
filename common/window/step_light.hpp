#pragma once

#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// How near the time step is to a limit, and so to losing the run: amber above 80 % of a limit of stability,
/// red above all of it. A limit of accuracy is never more than calm, nor any where the scheme divides dt
/// itself.
struct StepLight {
  enum class Colour { calm, amber, red } colour = Colour::calm;
  StepLimit limit;
  double share = 0;    ///< dt over it
  bool binds = false;  ///< it sets dt, or is the one that dt is nearest to losing the run by
};

/// Of the limit of stability that is most in danger, or else of the limit that sets dt.
StepLight step_light(const Simulation& simulation);

/// Of each limit that there is, in the order of the laws.
std::vector<StepLight> step_lights(const Simulation& simulation);

}  // namespace clapotis
