#pragma once

#include <functional>
#include <vector>

#include "common/simulation/simulation.hpp"

namespace clapotis {

/// Seconds that a step of each of two simulations took, one after the other.
struct Turn {
  double base, other;

  /// How much longer a step of the other one takes.
  [[nodiscard]] double ratio() const { return other / base; }
};

/// Turns of so many steps each, by this clock. A machine that others use too changes its speed from second to
/// second: what is measured in turns meets it in the same mood, and the median of the ratios is steady.
std::vector<Turn> in_turns(Simulation& base, Simulation& other, int turns, int steps,
                           const std::function<double()>& clock);

/// Of an odd number of them, the one in the middle; between the two in the middle otherwise.
double median(std::vector<double> values);

/// The median of ratio() or of another number of a turn.
double median_of(const std::vector<Turn>& turns, const std::function<double(const Turn&)>& number);

}  // namespace clapotis
