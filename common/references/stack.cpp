#include "common/references/stack.hpp"

#include <cmath>

#include "common/references/require.hpp"

namespace clapotis {

RestingStack resting_stack(int count, double mass, double gravity, double stiffness, double radius) {
  const Demand demand{"resting_stack"};
  require(count >= 1, "resting_stack", "count", count, ">= 1");
  demand.positive(mass, "mass [kg]");
  demand.not_negative(gravity, "gravity [m/s^2]");
  demand.positive(stiffness, "stiffness [N/m]");
  demand.positive(radius, "radius [m]");
  const double weight = mass * gravity;
  const double largest_overlap = (count - 1) * weight / stiffness;
  require(largest_overlap < 2 * radius, "resting_stack", "overlap of the lowest contact [m]", largest_overlap,
          "below the diameter: raise the stiffness or lower the count");

  RestingStack stack{{radius}, {}, count * weight};
  for (int above = count - 1; above >= 1; --above) {
    stack.overlaps.push_back(above * weight / stiffness);
    stack.heights.push_back(stack.heights.back() + 2 * radius - stack.overlaps.back());
  }
  return stack;
}

}  // namespace clapotis
