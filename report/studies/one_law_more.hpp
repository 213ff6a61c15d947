#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis::studies {

/// A scene as it is with one law more.
struct OneLawMore {
  std::string law;  ///< as it is read; of the scene itself: its laws
  std::function<std::unique_ptr<Simulation>()> build;
};

/// A scene, and the same with each of several laws more.
struct Priced {
  std::string scene;
  OneLawMore itself;
  std::vector<OneLawMore> more;
};

std::vector<Priced> priced_discs();
/// A block of liquid that has nothing but its pressure.
Priced priced_liquid();
/// Scenes of stages 4 and 5, where a parameter, or the scene beside it, adds the law.
std::vector<Priced> priced_scenes();

}  // namespace clapotis::studies
