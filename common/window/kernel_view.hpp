#pragma once

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// Shows the kernel at work on the chosen particle in place of the energies, or no longer. When none is
/// chosen it takes one in the middle; in a scene without a kernel it says so.
void toggle_kernel(WindowState& state);

/// Its box to tick in the panel.
void lay_out_kernel_tick(WindowState& state, Controls& controls);

}  // namespace clapotis
