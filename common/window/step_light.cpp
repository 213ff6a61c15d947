#include "common/window/step_light.hpp"

namespace clapotis {

StepLight step_light(const Simulation& simulation) {
  constexpr double close = 0.8, rounding = 1e-9;
  const double dt = simulation.dt();
  const StepLimit* nearest = nullptr;
  for (const auto& limit : simulation.limits())
    if (limit.stability && (nearest == nullptr || limit.limit < nearest->limit)) nearest = &limit;
  const double share = nearest != nullptr ? dt / nearest->limit : 0;
  using enum StepLight::Colour;
  if (share > 1 + rounding) return {red, *nearest, share};
  if (share > close + rounding) return {amber, *nearest, share};
  const auto& binding = simulation.binding_limit();
  return {calm, binding, dt / binding.limit};
}

}  // namespace clapotis
