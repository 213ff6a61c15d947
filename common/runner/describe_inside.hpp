#pragma once

#include <vector>

#include "common/runner/inside.hpp"
#include "common/runner/plot.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// All that there is to see inside a particle: its neighbours, the forces on it, its values, and if wanted
/// the plots of its kernel. Where particles do not act on each other nobody is near it, and its support is 0.
/// What follows is as if nobody had looked.
///
/// On a particle at rest on a wall, which presses on it, the wall is shown to bear what presses; where liquid
/// comes in or goes out nothing acts. The acceleration is that of all forces shown.
Chosen look_inside(Simulation& simulation, Index particle, bool with_kernel = false);

/// The kernel at work on a particle, over r/h: W with the share V_j W of each neighbour, their sum as it
/// grows with the distance, W' with its shares. In a scene of discs the law of contact over the distance;
/// nothing in a scene of single particles. Within a look at `system`, which is the simulation's.
std::vector<Plot> kernel_plots(const Simulation& simulation, const System& system, Index particle);

}  // namespace clapotis
