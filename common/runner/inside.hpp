#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "common/particles/vec.hpp"
#include "common/runner/canvas.hpp"
#include "common/runner/plot.hpp"

namespace clapotis {

/// A force on the chosen particle, shown as an arrow.
struct ForceArrow {
  std::string law;  ///< "pressure"; of the sum "m a"
  Vector force{0, 0};
  Colour colour;
};

/// A line of the table about the chosen particle: name and value stand in columns.
struct ParticleFact {
  std::string name, value;
  std::optional<Colour> colour = {};  ///< of the arrow that it belongs to
};

/// One particle, chosen by the user, and all that there is to see inside it: who is near it, who was asked,
/// what acts on it. Plain data, as the picture that it belongs to.
struct Chosen {
  Eigen::Index particle = 0;
  std::vector<Eigen::Index> neighbours;
  double support = 0;                      ///< radius within which particles act on each other [length unit]
  std::string label;                       ///< "particle 17: 20 neighbours"
  std::vector<Eigen::Index> in_vain = {};  ///< candidates that were tested and are out of reach
  std::string in_vain_label = {};          ///< "12 more tested"
  std::vector<Vector> walls = {};          ///< particles of walls within the support [length unit]
  Corners visited = {};                    ///< the cells that were looked through; empty without a grid
  std::vector<ForceArrow> forces = {};     ///< of each law, and at the end their sum
  double full_force = 0;                   ///< that has the longest arrow [force_unit]; 0: none acts
  std::string force_unit = {};             ///< "N/m"
  std::string title = {};                  ///< of the table; empty: there is none
  std::vector<ParticleFact> facts = {};    ///< about the particle, then one for each of `forces`
  std::vector<Plot> kernel = {};           ///< at work on it, if asked for; not part of the picture
};

/// The colour of a law's arrow: the same in all scenes, different from those of the laws before it. M. Okabe
/// and K. Ito, Color Universal Design (2008).
[[nodiscard]] Colour law_colour(std::string_view law, const std::vector<ForceArrow>& before);

}  // namespace clapotis
