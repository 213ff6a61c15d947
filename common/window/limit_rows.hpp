#pragma once

#include "common/window/controls.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// The limits of the time step, one line each: name, formula, value, and as a bar how much of it dt takes.
/// The one that binds is marked.
void lay_out_limits(const WindowState& state, Controls& controls);

/// For the heading: what sets dt, or that it is near a limit of stability or beyond it.
struct StepSentence {
  std::string words;
  Colour colour;
};
[[nodiscard]] StepSentence about_step(const Simulation& simulation);

}  // namespace clapotis
