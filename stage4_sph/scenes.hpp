#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage4 {

/// dam_break (the default), still_water, elliptical_drop, drop_impact, square_patch, acoustic, handout.
Stage stage();

}  // namespace clapotis::stage4
