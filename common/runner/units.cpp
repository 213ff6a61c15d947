#include "common/runner/units.hpp"

#include <array>

namespace clapotis {
namespace {

bool in_metres(const Simulation& simulation) { return simulation.scene().length_unit == "m"; }

std::string of(const Simulation& simulation, std::string_view solid, std::string_view fluid) {
  return with_length(simulation.setup().fluid ? fluid : solid, simulation.scene().length_unit);
}

}  // namespace

std::string with_length(std::string_view unit, std::string_view length_unit) {
  std::string text;
  for (const char letter : unit) {
    if (letter == 'L') {
      text += length_unit;
    } else {
      text += letter;
    }
  }
  return text;
}

std::string energy_unit(const Simulation& simulation) { return of(simulation, "kg L^2/s^2", "kg L/s^2"); }

std::string momentum_unit(const Simulation& simulation) { return of(simulation, "kg L/s", "kg/s"); }

std::string short_energy_unit(const Simulation& simulation) {
  return in_metres(simulation) ? of(simulation, "J", "J/L") : energy_unit(simulation);
}

std::string short_force_unit(const Simulation& simulation) {
  return in_metres(simulation) ? of(simulation, "N", "N/L") : of(simulation, "kg L/s^2", "kg/s^2");
}

std::string short_unit(std::string_view unit, std::string_view length_unit) {
  auto text = with_length(unit, length_unit);
  return text == "kg/(m s^2)" ? "Pa" : text;
}

std::string printed(std::string unit) {
  using Raised = std::pair<std::string_view, std::string_view>;
  for (const auto& [figure, raised] : std::array{Raised{"^2", "²"}, Raised{"^3", "³"}})
    for (auto at = unit.find(figure); at != std::string::npos; at = unit.find(figure))
      unit.replace(at, figure.size(), raised);
  return unit;
}

}  // namespace clapotis
