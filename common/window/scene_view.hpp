#pragma once

#include "common/runner/sheet.hpp"
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
  /// The right one of two sides, if there are two.
  [[nodiscard]] const std::optional<Beside>& beside() const { return beside_; }
  [[nodiscard]] const std::vector<Plot>& curves() const { return plots_; }
  /// The part of the window that shows the scene's own piece of the plane.
  [[nodiscard]] Box domain() const { return clapotis::domain(picture_, view_); }
  /// Where the world was painted last.
  [[nodiscard]] const PictureView& view() const { return view_; }
  /// Where the right side was.
  [[nodiscard]] const Box& right_half() const { return right_view_.scene; }
  /// The view of the left side, or of the right one where that is.
  [[nodiscard]] const PictureView& view_at(Point pixel) const {
    return beside_ && right_view_.shows(pixel) ? right_view_ : view_;
  }

 private:
  void describe_all(WindowState& state);
  void describe_curves(const WindowState& state, double width);
  void share_ranges(Sight& sight);
  void paint_scenes(Canvas& canvas, WindowState& state, const Box& area);
  void describe_sides(WindowState& state, SideBySide& sides);
  void paint_right(Canvas& canvas, WindowState& state, const SplitArea& area);
  void paint_velocities(Canvas& canvas, WindowState& state, const Simulation& simulation,
                        const PictureView& view);
  void paint_arrow_key(Canvas& canvas, const WindowState& state, double speed);
  void paint_brush(Canvas& canvas, const WindowState& state);

  Painter painter_;
  Picture picture_;
  PictureView view_;
  std::optional<Beside> beside_;
  PictureView right_view_;
  std::vector<Plot> plots_;
  std::vector<Point> ends_;
  double arrow_speed_ = 0;  ///< of the longest arrow, on both sides [L/s]
};

}  // namespace clapotis
