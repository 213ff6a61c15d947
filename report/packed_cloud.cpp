#include "report/packed_cloud.hpp"

#include <cmath>

namespace clapotis {

std::unique_ptr<Simulation> packed_cloud(const Scene& scene, long count, int threads, const Overrides& more) {
  constexpr double h = 10;
  const auto across = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(count) * std::sqrt(0.75))));
  const long lines = (count + across - 1) / across;
  const double width = 2 * h * (static_cast<double>(across) + 0.5);
  const double height = 2 * h * (static_cast<double>(lines - 1) * std::sqrt(0.75) + 1.001);
  Overrides overrides{{"particles", {std::to_string(count)}},
                      {"width", {to_text(width)}},
                      {"height", {to_text(height)}},
                      {"y0", {"0"}}};
  for (const auto& [name, value] : more) overrides.insert_or_assign(name, value);
  auto simulation = std::make_unique<Simulation>(scene, overrides, default_integrator, threads);
  simulation->system().position *= 0.99;
  simulation->step();
  return simulation;
}

}  // namespace clapotis
