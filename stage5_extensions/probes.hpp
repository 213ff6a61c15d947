#pragma once

#include <string>

#include "common/laws/fluid.hpp"
#include "common/simulation/scene.hpp"

/// What is measured at fixed places of a tank of water between the walls x = 0 and x = width.
namespace clapotis::stage5 {

/// A strip with soft edges, `soft` to either side of its middle: a weight whose integral is 1 [1/L].
double soft_strip(double distance, double soft);

/// A wave probe: how far the surface at x is above its place at the start. The height is what is in a strip
/// around x over the strip's width; the strip has soft edges, four spacings to either side, and goes on
/// behind the walls as in a mirror.
Measure elevation(std::string name, double x, double width, const Fluid& fluid, const Particles& start);

/// Pressure of the water at r: the value there of the plane that fits best, weighted with the kernel, the
/// pressures of the particles within its support 2 h. A hydrostatic pressure is a plane, so it is right at a
/// wall as well, where there is water on one side only. 0 where there is no water, or tension.
double pressure_at(const Vector& r, const Fluid& fluid, const Particles& particles);

/// That pressure, as a column of the series.
Measure pressure(std::string name, const Vector& r, const Fluid& fluid);

}  // namespace clapotis::stage5
