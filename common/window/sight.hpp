#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/runner/colour_range.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/picture.hpp"
#include "common/window/session.hpp"

namespace clapotis {

/// How the scene is looked at: nothing here touches the physics.
struct Sight {
  Viewpoint viewpoint;
  ColourRange colour_range, arrow_range, force_range;
  double zoom = 1;              ///< 1: the whole scene
  Eigen::Vector2d moved{0, 0};  ///< of the middle, away from the scene's [L]
  Eigen::Vector2d tank{0, 0};   ///< how far a hand has moved the tank from its place [L]
  bool vectors = false, plots = true;

  /// What was said of particles and places of the last scene does not hold in the next.
  void look_at_other_scene(const Simulation& simulation);
  void next_colouring(const Simulation& simulation);
  void colour_by(const std::string& quantity);
  void select_next(const Simulation& simulation, int direction);
  /// The particle that is nearest to the middle of all.
  void select_middle(const Simulation& simulation);
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
