#pragma once

#include "common/runner/plot.hpp"
#include "common/window/window_state.hpp"

namespace clapotis {

/// The left part of the window: the scene as files show it, and over it what only somebody who points at it
/// wants to see: velocities, how far the mouse reaches.
class SceneView {
 public:
  void paint(Canvas& canvas, WindowState& state, const Box& area);

  /// Writes what was painted last as a picture of its own and returns the file's name. Throws FileError.
  [[nodiscard]] std::string save(const Session& session) const;
  /// What was painted last.
  [[nodiscard]] const Picture& picture() const { return picture_; }
  [[nodiscard]] const std::vector<Plot>& curves() const { return plots_; }
  /// The part of the window that shows the scene's own piece of the plane.
  [[nodiscard]] Box domain() const;
  /// Where the world was painted last.
  [[nodiscard]] const PictureView& view() const { return view_; }

 private:
  void paint_velocities(Canvas& canvas, WindowState& state);
  void paint_arrow_key(Canvas& canvas, const WindowState& state, double speed);
  void paint_brush(Canvas& canvas, const WindowState& state);

  Painter painter_;
  Picture picture_;
  PictureView view_;
  std::vector<Plot> plots_;
  std::vector<Point> ends_;
};

}  // namespace clapotis
