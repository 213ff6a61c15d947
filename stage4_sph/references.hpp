#pragma once

#include "common/simulation/scene.hpp"
#include "stage4_sph/liquid.hpp"

namespace clapotis::stage4 {

/// Front against the experiment of Koshizuka & Oka 1996, in column widths a.
Reference dam_break_experiment(double a, double gravity);

/// L2 norm of the error of pressure over that of the exact pressure of a column at rest.
Reference hydrostatic_pressure(const HydrostaticColumn& exact, double height);

/// Semi-axis along y, from the outermost particle, over the exact one.
Reference ellipse(const Fluid& fluid, double radius, double rate);

/// Throws BadInput, naming the parameter, when it does not fit in the tank.
void require_inside_tank(Parameters& p, const Tank& tank, const std::vector<Parameter>& sides);

}  // namespace clapotis::stage4
