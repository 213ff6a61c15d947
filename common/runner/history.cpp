#include "common/runner/history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

Plot energy_plot(const std::vector<Sample>& samples, const Simulation& simulation) {
  const auto& w = words();
  const bool is_fluid = simulation.setup().fluid.has_value();
  const bool has_weight = !is_fluid || simulation.parameters().find("gravity") != nullptr;
  const auto curve = [&](std::string_view label, std::size_t colour, double (*value)(const Sample&)) {
    return curve_over_time(samples, label, ink::palette().curves[colour], value);
  };
  auto plot = energies_over_time(simulation);
  plot.curves.push_back(curve(w.kinetic, 0, [](const Sample& s) { return s.energy.kinetic; }));
  if (has_weight)
    plot.curves.push_back(curve(w.potential, 2, [](const Sample& s) { return s.energy.potential; }));
  if (is_fluid)
    plot.curves.push_back(curve(w.internal, 3, [](const Sample& s) { return s.energy.internal; }));
  else if (simulation.model().has_pairs())
    plot.curves.push_back(curve(w.elastic, 3, [](const Sample& s) { return s.energy.elastic; }));
  plot.curves.push_back(curve(w.mechanical, 1, [](const Sample& s) { return s.energy.mechanical(); }));
  plot.curves.push_back(curve(w.total, 5, [](const Sample& s) { return s.energy.total(); }));
  plot.curves.back().dashed = true;
  return plot;
}

Plot error_plot(const std::vector<Sample>& samples, const Reference& reference) {
  auto plot = errors_over_time(reference);
  plot.curves.push_back(curve_over_time(samples, called(reference.measure), ink::palette().curves[1],
                                        [](const Sample& s) { return s.error; }));
  return plot;
}

}  // namespace

Sample History::sample(const Simulation& simulation, const Energy& energy) {
  return {simulation.time(), energy, simulation.error(), max_speed(simulation.particles())};
}

void History::add(const Simulation& simulation, const Energy& energy) {
  latest_ = sample(simulation, energy);
  largest_error_ = std::fmax(largest_error_, latest_.error);
  largest_speed_ = std::fmax(largest_speed_, latest_.max_speed);
  kept_.add(latest_);
}

void History::cut() { kept_.replace(samples()); }

std::vector<Sample> History::samples() const {
  const auto& kept = kept_.kept();
  const auto later = std::ranges::upper_bound(kept, latest_.time, {}, &Sample::time);
  std::vector<Sample> all(kept.begin(), later);
  if (!all.empty() && all.back().time < latest_.time) all.push_back(latest_);
  return all;
}

Curve curve_over_time(const std::vector<Sample>& samples, std::string_view label, Colour colour,
                      double (*value)(const Sample&)) {
  Curve curve;
  curve.label = label;
  curve.colour = colour;
  for (const auto& sample : samples) {
    curve.xs.push_back(sample.time);
    curve.ys.push_back(value(sample));
  }
  return curve;
}

Plot plot_over_time(std::string title, std::string y_label) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = "t [s]";
  plot.y_label = std::move(y_label);
  return plot;
}

Plot energies_over_time(const Simulation& simulation) {
  return plot_over_time(std::string(words().plot_energies),
                        "E [" + printed(short_energy_unit(simulation)) + "]");
}

Plot errors_over_time(const Reference& reference) {
  auto plot = plot_over_time(say(words().plot_error, fmt::arg("reference", called(reference.name))),
                             reference.unit.empty() ? "" : fmt::format("[{}]", printed(reference.unit)));
  plot.log_y = true;
  return plot;
}

std::vector<Plot> plots(const History& history, const Simulation& simulation) {
  const auto samples = history.samples();
  std::vector<Plot> all{energy_plot(samples, simulation)};
  if (const auto& reference = simulation.setup().reference) all.push_back(error_plot(samples, *reference));
  return all;
}

}  // namespace clapotis
