#include "common/references/stack.hpp"

#include <cmath>

#include "common/references/require.hpp"

namespace clapotis {

RestingStack resting_stack(int count, double mass, double gravity, double stiffness, double radius) {
  const auto positive = [](double value, const char* name) {
    require(value > 0 && std::isfinite(value), "resting_stack", name, value, "finite and > 0");
  };
  require(count >= 1, "resting_stack", "count", count, ">= 1");
  positive(mass, "mass [kg]");
  require(gravity >= 0 && std::isfinite(gravity), "resting_stack", "gravity [m/s^2]", gravity,
          "finite and >= 0");
  positive(stiffness, "stiffness [N/m]");
  positive(radius, "radius [m]");
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
