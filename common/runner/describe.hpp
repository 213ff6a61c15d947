#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/runner/picture.hpp"
#include "common/simulation/simulation.hpp"

namespace clapotis {

/// What is to be shown of a simulation.
struct Viewpoint {
  std::string colour_by = "speed";                 ///< speed, force, a column of the scene, or plain
  std::optional<std::pair<double, double>> range;  ///< of the colours; 0 to the greatest value otherwise
  bool ghosts = true;                              ///< where the reference has the particles
  bool grid = false;                               ///< the cells of the neighbour search
  std::optional<Index> chosen = {};                ///< the particle whose neighbours are shown
};

/// What the discs can be coloured by: speed, force |m a|, the scene's columns, plain.
std::vector<std::string> colourings(const Simulation& simulation);

/// The picture of a simulation as it stands: the same for the window and for files.
Picture describe(const std::string& stage_title, Simulation& simulation, const Viewpoint& viewpoint = {});

}  // namespace clapotis
