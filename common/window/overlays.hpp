#pragma once

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

// What is laid over the scene when there is something to say. `area` is the scene's part of the window.

/// Why the run stopped, and the ways on: reset, another integrator.
void lay_out_divergence(WindowState& state, const Box& area, Controls& controls);
/// The last sentence for the user, until its time is over.
void lay_out_notice(WindowState& state, const Box& area, double elapsed);
/// That a video is being made, and how long it is so far.
void lay_out_recording(const WindowState& state, const Box& area);
void lay_out_help(WindowState& state, const Box& area);

}  // namespace clapotis
