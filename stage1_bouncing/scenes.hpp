#pragma once

#include "common/simulation/scene.hpp"

namespace clapotis::stage1 {

/// bounce: one particle in the window, gravity, drag, four walls. drop: the vertical fall with its closed
/// form.
Stage stage();

}  // namespace clapotis::stage1
