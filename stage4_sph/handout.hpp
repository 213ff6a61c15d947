#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage4 {

/// The handout's section VI as printed, in pixels: particles of radius h stacked at a spacing of 2h, rho_0 =
/// m/(pi h^2), reflecting walls, tau = CFL h/c. `viscosity_form` and `signs` choose what of it is corrected.
Setup handout(Parameters& p);

}  // namespace clapotis::stage4
