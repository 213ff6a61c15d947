#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/runner/describe.hpp"
#include "common/runner/picture.hpp"
#include "common/window/session.hpp"

namespace clapotis {

/// A range of colours that does not flicker: between round numbers, growing at once with what is shown and
/// shrinking only when less than a third of it is used. Or the range that was locked.
class ColourRange {
 public:
  /// The range for values between lo and hi. An end that is 0, and ends that are opposite, remain so.
  std::pair<double, double> follow(double lo, double hi);
  bool locked = false;

 private:
  double low_ = 0, high_ = 0;
};

/// How the scene is looked at: nothing here touches the physics.
struct Sight {
  Viewpoint viewpoint;
  ColourRange colour_range, arrow_range;
  double zoom = 1;              ///< 1: the whole scene
  Eigen::Vector2d moved{0, 0};  ///< of the middle, away from the scene's [L]
  Eigen::Vector2d tank{0, 0};   ///< how far a hand has moved the tank from its place [L]
  bool vectors = false, plots = true;

  /// What was said of particles and places of the last scene does not hold in the next.
  void look_at_other_scene(const Simulation& simulation);
  void next_colouring(const Simulation& simulation);
  void colour_by(const std::string& quantity);
  void select_next(const Simulation& simulation, int direction);
  /// The particle at that place of the view, within `reach` pixels of its rim; none elsewhere.
  void select_at(const Simulation& simulation, const PictureView& view, Point pixel, double reach);

  /// The view of `picture` in `area`, with zoom and move.
  [[nodiscard]] PictureView view(const Picture& picture, const Box& area, double scale) const;
  /// Zooms by `factor`, keeping the point of the world that is at `pixel` where it is.
  void zoom_at(const PictureView& view, Point pixel, double factor);
  void move_by(const PictureView& view, Point pixels);
  void show_whole_scene();
};

}  // namespace clapotis
