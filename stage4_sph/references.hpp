#pragma once

#include "common/references/elliptical_drop.hpp"
#include "common/simulation/scene.hpp"
#include "stage4_sph/liquid.hpp"

namespace clapotis::stage4 {

/// The front: the edge of the foremost particle, half a spacing beyond its centre.
Measure front(double spacing);
/// It against the experiment of Koshizuka & Oka 1996, in column widths a.
Reference dam_break_experiment(const Measure& front, double a, double gravity);

/// L2 norm of the error of pressure over that of the exact pressure of a column at rest.
/// `width` is that of the tank [L].
Reference hydrostatic_pressure(const HydrostaticColumn& exact, double height, double width);

/// How much longer than at the start the drop is along y: by its outermost particle, and by the second moment
/// of all.
std::vector<Measure> stretches(const Vectors& start);
/// The first of them against the exact one.
Reference ellipse(const std::vector<Measure>& stretches, const EllipticalDrop& exact);

/// Pressure in the middle, the mean of the four nearest particles.
Measure centre_pressure();

/// Throws BadInput, naming the parameter, when it does not fit in the tank.
void require_inside_tank(Parameters& p, const Tank& tank, const std::vector<Parameter>& sides);

}  // namespace clapotis::stage4
