#pragma once

#include <optional>

#include "common/window/input.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// What the pressed mouse does to a liquid that has a hand: the chosen tool with the left button; with the
/// right one it pulls, or pushes where the left one pulls.
class MouseTool {
 public:
  /// True when the input was for the tool, and for nobody else.
  bool handle(WindowState& state, const PictureView& view, const Input& input);
  /// After the steps of a frame: moves a tank that was grabbed after the mouse, and back when it is let go.
  void follow(WindowState& state);

 private:
  void begin(WindowState& state, const PictureView& view, Tool tool, Point at);
  void go_on(WindowState& state, const PictureView& view, Point at);
  void end(WindowState& state);
  void apply(WindowState& state, const PictureView& view, Point at);

  std::optional<Tool> tool_;   ///< in use, as long as a button is pressed
  Point begun_{}, applied_{};  ///< where the button went down, and where the tool last did something [pixel]
  Vector wanted_{0, 0};        ///< where the mouse wants the tank [L]
  Vector tank_{0, 0}, speed_{0, 0};  ///< where it is, and how fast [L], [L/s]
  long leaps_ = 0;
  bool left_behind_ = false;  ///< what the hand does belongs to a past moment
};

}  // namespace clapotis
