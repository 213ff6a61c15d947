#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/integrators/integrator.hpp"
#include "common/laws/fluid.hpp"
#include "common/simulation/model.hpp"
#include "common/simulation/parameters.hpp"
#include "common/simulation/shape.hpp"

namespace clapotis {

/// What a scene is measured against.
struct Reference {
  std::string name;     ///< for example "closed form"
  std::string measure;  ///< what the error is of, for example "|y - y_exact|"
  std::string unit;
  std::string source;  ///< author, year, or how it follows
  /// Error of the state as it stands; NaN where the reference does not hold (any more).
  std::function<double(const System&)> error;
  /// What of the reference can be drawn over the scene at time t, n x 2 [L]: points, of which `shape` says
  /// what they are; none where it does not hold (any more).
  std::function<Vectors(double t)> positions;
  Shape shape = Shape::particles;
  std::vector<std::string> labels = {};  ///< of the marks, one for each row
  /// What the run has where the reference has lines, where the particles themselves do not show it: points
  /// n x 2 [L].
  std::function<Vectors(const System&)> measured = {};
};

/// A number that is worth following in a scene, for example the front of a dam break.
struct Measure {
  std::string name;  ///< of the column in series.csv
  std::string unit;  ///< L stands for the scene's unit of length; "1" for a pure number
  std::function<double(const System&)> value;
};

/// The part of the plane that the window and pictures show [L].
struct View2D {
  double left, right, bottom, top;

  [[nodiscard]] bool contains(const Vector& r) const {
    return r.x > left && r.x < right && r.y > bottom && r.y < top;
  }
};

/// What a scene makes of its parameters: particles, laws, and what to compare with.
struct Setup {
  Particles particles;
  std::unique_ptr<Model> model;
  double radius =
      0;  ///< of the discs in the picture, and h of the acoustic limit h/c where there is no fluid [L]
  View2D view{};
  std::optional<Reference> reference = {};
  std::optional<Fluid> fluid = {};     ///< what the particles are, in stage 4 and on
  std::vector<Measure> measures = {};  ///< what the scene is about, besides energies: columns of series.csv
  bool locate_impacts = false;         ///< find each impact inside the step, instead of clamping after it
  std::string colour_by = "speed";     ///< what pictures of the scene show first: see `colourings`

  [[nodiscard]] Matter matter() const { return fluid ? Matter::liquid : Matter::particles; }
};

/// A set of values that shows something about a scene, by name, in place of its own defaults.
struct Preset {
  std::string name;
  Defaults values;
};

/// A way to compute the same scene that no parameter chooses: in the stage of the grid, the list of the stage
/// before. It shares everything with the scene but what it builds.
struct Rival {
  std::string what;        ///< for example "neighbour_search"
  std::string own, other;  ///< what the scene has, and what this: "grid", "list"
  std::string stage;       ///< where it is a scene of its own, by the same name
  std::function<Setup(Parameters&)> build;
};

/// A scene: a function from its parameters to a simulation. Reset, sweeps, tests, studies, comparison all
/// call it.
struct Scene {
  std::string name;
  std::string length_unit;  ///< "px" or "m"
  Defaults defaults;        ///< where they differ from those of the laws
  std::function<Setup(Parameters&)> build;
  std::vector<Preset> presets = {};
  /// What its two sides differ in at first when it is compared with itself, and the right side's value:
  /// "integrator", or a parameter. The rival where there is one, and none is stated.
  std::optional<std::pair<std::string, std::string>> beside = {};
  std::optional<Rival> rival = {};

  /// Its values, as given by `origin`; throws BadInput with the nearest name.
  [[nodiscard]] Overrides preset(std::string_view wanted, Origin origin) const;
};

/// A stage of the course: a program of its own.
struct Stage {
  std::string name;   ///< for example "stage2_cloud"
  std::string title;  ///< for example "Stage 2 - cloud"
  std::vector<Scene> scenes;

  /// The scene of that name, the first one for an empty name; throws BadInput with the nearest name.
  [[nodiscard]] const Scene& scene(std::string_view wanted) const&;
  [[nodiscard]] Scene scene(std::string_view wanted) && { return scene(wanted); }  // of a temporary: a copy
  /// What moves in its scenes.
  [[nodiscard]] Matter matter() const;
};

}  // namespace clapotis
