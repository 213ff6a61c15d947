#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/runner/picture.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// What is to be shown of a simulation.
struct Viewpoint {
  std::string colour_by = "speed";  ///< one of `colourings`
  /// Of the colours; that of almost all values otherwise.
  std::optional<std::pair<double, double>> range = {};
  bool ghosts = true;                ///< where the reference has the particles
  bool grid = false;                 ///< the cells of the neighbour search
  std::optional<Index> chosen = {};  ///< id of the particle that is looked into
  bool kernel = false;               ///< and the plots of its kernel are wanted
};

/// What the particles can be coloured by: speed, in a fluid pressure, density_error and density, then force
/// |m a|, the scene's other columns, plain.
std::vector<std::string> colourings(const Simulation& simulation);
/// The wanted one of them, or the scene's own; throws BadInput with the nearest name.
std::string colouring(const Simulation& simulation, const std::optional<std::string>& wanted);

/// What a column of the scene is called in formulas: "density" is rho.
std::string symbol(std::string_view column);

/// The time step, as short as can be read, and of one width where each step has its own.
std::string step_text(const Simulation& simulation);

/// The picture of a simulation as it stands: the same for the window and for files.
Picture describe(const std::string& stage_title, Simulation& simulation, const Viewpoint& viewpoint = {});

}  // namespace clapotis
