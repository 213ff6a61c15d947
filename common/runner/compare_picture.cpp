#include "common/runner/compare_picture.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/runner/ticks.hpp"
#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

using Value = double (*)(const Sample&);

/// What both sides have noted.
struct Samples {
  std::vector<Sample> left, right;
};

Plot energy_plot(const Samples& samples, const Simulation& simulation) {
  const auto& w = words();
  auto plot = energies_over_time(simulation);
  const Value mechanical = [](const Sample& s) { return s.energy.mechanical(); };
  const Value total = [](const Sample& s) { return s.energy.total(); };
  plot.curves = {curve_over_time(samples.left, w.compare_left, left_colour(), mechanical),
                 curve_over_time(samples.right, w.compare_right, right_colour(), mechanical),
                 curve_over_time(samples.left, w.total, left_colour(), total),
                 curve_over_time(samples.right, "", right_colour(), total)};
  plot.curves[2].dashed = plot.curves[3].dashed = true;
  return plot;
}

/// Of each side that has, or has had, a reference.
std::optional<Plot> error_plot(const Samples& samples, const Simulation& left, const Simulation& right) {
  const auto& reference = left.setup().reference ? left.setup().reference : right.setup().reference;
  if (!reference) return std::nullopt;
  auto plot = errors_over_time(*reference);
  const Value error = [](const Sample& s) { return s.error; };
  plot.curves = {curve_over_time(samples.left, words().compare_left, left_colour(), error),
                 curve_over_time(samples.right, words().compare_right, right_colour(), error)};
  return plot;
}

Plot distance_plot(const std::vector<Difference>& distances, const Simulation& simulation) {
  const auto& w = words();
  auto plot = plot_over_time(std::string(w.compare_plot),
                             std::string(w.compare_distance) + " [" + simulation.scene().length_unit + "]");
  Curve largest, rms;
  largest.label = w.compare_curve_largest;
  largest.colour = ink::palette().curves[2];
  rms.label = w.compare_curve_rms;
  rms.colour = ink::palette().curves[3];
  for (const auto& distance : distances) {
    for (auto* curve : {&largest, &rms}) curve->xs.push_back(distance.time);
    largest.ys.push_back(distance.largest);
    rms.ys.push_back(distance.rms);
  }
  plot.curves.push_back(std::move(largest));
  if (simulation.particles().size() > 1) plot.curves.push_back(std::move(rms));  // of one they are the same
  plot.log_y = std::ranges::any_of(distances, [](const Difference& d) { return d.largest > 0; });
  return plot;
}

/// "+2.4 %", "+2e-06" or "x5.9", whichever is shorter.
std::string drift_text(double drift) {
  if (drift == 0) return "0";
  if (drift >= 1) return "x" + two_digits(1 + drift);
  return std::abs(drift) >= 1e-3 ? fmt::format("{:+.2g} %", 100 * drift) : fmt::format("{:+.0e}", drift);
}

/// "1.5 ms/s", "33 s/s": per simulated second.
std::string cost_text(double milliseconds) {
  if (!std::isfinite(milliseconds)) return "…";
  return milliseconds < 1000 ? two_digits(milliseconds) + " ms/s" : two_digits(milliseconds / 1000) + " s/s";
}

std::string cost_line(const Side& side) {
  return say(words().compare_cost, fmt::arg("cost", cost_text(side.cost())),
             fmt::arg("evaluations", grouped(side.simulation->system().force_evaluations, " ")),
             fmt::arg("drift", drift_text(side.energy_drift())));
}

}  // namespace

void Distances::add(const Comparison& comparison) {
  if (comparison.difference()) kept_.add(*comparison.difference());
}

std::vector<Plot> compare_plots(const Distances& distances, const Side& left, const Side& right) {
  const Samples samples{left.history.samples(), right.history.samples()};
  std::vector<Plot> plots{energy_plot(samples, *left.simulation)};
  if (auto errors = error_plot(samples, *left.simulation, *right.simulation))
    plots.push_back(std::move(*errors));
  if (!distances.kept().empty()) plots.push_back(distance_plot(distances.kept(), *left.simulation));
  return plots;
}

Picture describe_side(Side& side, const std::string& what, Colour mark, const Viewpoint& viewpoint) {
  auto picture = describe(side.stage_title, *side.simulation, viewpoint);
  picture.title = what;
  picture.subtitle = cost_line(side);
  picture.legend = false;
  picture.mark = mark;
  if (side.divergence) picture.alarm = side.divergence->what();
  return picture;
}

void share_colours(Picture& left_picture, Picture& right_picture, const Side& left, const Side& right) {
  auto &l = left_picture.colours, &r = right_picture.colours;
  if (!left.runs()) std::tie(l.lo, l.hi) = std::pair(r.lo, r.hi);
  if (left.runs() && right.runs()) {
    l.lo = std::min(l.lo, r.lo);
    l.hi = std::max(l.hi, r.hi);
  }
  r = l;
}

Beside beside(const Side& left, const Side& right, Picture right_picture, double time) {
  const auto name = [](const Side& side) {
    return std::string(called(side.stage_title)) + " - " + side.simulation->scene().name;
  };
  auto title = name(left);
  if (name(right) != title) title += " | " + name(right);
  const auto of_both = [&](auto text) {
    const std::string one = text(*left.simulation), other = text(*right.simulation);
    return one == other ? one : one + " | " + other;
  };
  return {.title = std::move(title),
          .subtitle =
              fmt::format("t = {:.3f} s   dt = {} s   N = {}", time, of_both(step_text),
                          of_both([](const Simulation& s) { return std::to_string(s.particles().size()); })),
          .right = std::move(right_picture)};
}

}  // namespace clapotis
