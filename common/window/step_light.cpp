#include "common/window/step_light.hpp"

#include <algorithm>
#include <cmath>

namespace clapotis {
namespace {

StepLight light_of(const StepLimit& limit, const Simulation& simulation) {
  constexpr double close = 0.8, rounding = 1e-9;
  using enum StepLight::Colour;
  const double share = simulation.dt() / limit.limit;
  if (!limit.stability || simulation.controls_error()) return {calm, limit, share};
  return {share > 1 + rounding ? red : share > close + rounding ? amber : calm, limit, share};
}

}  // namespace

std::vector<StepLight> step_lights(const Simulation& simulation) {
  std::vector<StepLight> lights;
  for (const auto& limit : simulation.limits())
    if (std::isfinite(limit.limit)) lights.push_back(light_of(limit, simulation));
  if (lights.empty()) return lights;
  const auto danger = [](const StepLight& light) {
    return std::pair(light.colour, light.limit.stability ? light.share : 0);
  };
  auto first = std::ranges::max_element(lights, {}, danger);
  if (first->colour == StepLight::Colour::calm)
    first = std::ranges::find(lights, simulation.binding_limit().name,
                              [](const StepLight& light) { return light.limit.name; });
  if (first != lights.end()) first->binds = true;
  return lights;
}

StepLight step_light(const Simulation& simulation) {
  const auto lights = step_lights(simulation);
  const auto first = std::ranges::find(lights, true, &StepLight::binds);
  return first != lights.end() ? *first : light_of(simulation.binding_limit(), simulation);
}

}  // namespace clapotis
