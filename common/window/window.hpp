#pragma once

#include "common/runner/run_stage.hpp"

namespace clapotis {

/// Plays the scenes of a stage in a window until the user closes it; returns the exit code. Needs a display
/// (display_available). Throws BadInput when the first scene cannot be built.
int run_window(const Stage& stage, const Options& options);

/// What a stage's main hands to run_stage.
WindowDoor window_door();

}  // namespace clapotis
