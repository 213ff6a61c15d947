#pragma once

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// Of the strip below the scene [pixel].
[[nodiscard]] double time_line_height(double scale);

/// The time from the oldest moment kept to the newest, and where in it the scene stands; dragged, it brings
/// the scene there. Left of it a button for one step back.
void lay_out_time_line(WindowState& state, const Box& area, Controls& controls);

}  // namespace clapotis
