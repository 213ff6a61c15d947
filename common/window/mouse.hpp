#pragma once

#include <optional>

#include "common/window/input.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// What the mouse does in the scene: click selects, wheel zooms, middle drag moves the view.
class SceneMouse {
 public:
  /// `shown` is what the view shows.
  void handle(WindowState& state, const Simulation& shown, const PictureView& view, const Input& input);

 private:
  std::optional<Point> pressed_;  ///< where the left button went down
  std::optional<Point> dragged_;  ///< where the middle button was last seen
};

}  // namespace clapotis
