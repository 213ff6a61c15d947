#pragma once

#include <map>
#include <string>

#include "common/window/trace.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// Compares what the user sees with what was seen a frame ago, and tells the trace what changed: one line
/// each, such as "paused", "step 12 t=0.0024 energy=...", "parameter gravity=300", "scene pair", "resized
/// 900x600".
class Watch {
 public:
  void look(WindowState& state, Point window, Trace& trace);

 private:
  std::map<std::string, std::string> seen_;  ///< the lines by the thing they are about
  long frames_ = 0;
};

}  // namespace clapotis
