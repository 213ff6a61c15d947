#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage3 {

/// The scenes and laws of stage 2; only the neighbour search is another.
Stage stage();

}  // namespace clapotis::stage3
