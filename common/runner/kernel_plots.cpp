#include <algorithm>
#include <cmath>
#include <functional>

#include "common/runner/describe_inside.hpp"
#include "common/runner/ink.hpp"
#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr int curve_points = 150;
constexpr double beyond = 1.25;  ///< how far the abscissa goes [supports]
Colour of_liquid() { return ink::palette().curves[0]; }
Colour of_walls() { return ink::palette().curves[4]; }
Colour of_law() { return ink::palette().curves[5]; }
Colour of_sum() { return ink::palette().curves[1]; }

const Words::Window::Kernel& w() { return words().window.kernel; }

Curve law_curve(double start, double end, const std::function<double(double)>& value) {
  Curve curve{.label = {}, .colour = of_law(), .xs = {}, .ys = {}};
  for (int k = 0; k <= curve_points; ++k) {
    curve.xs.push_back(start + (end - start) * k / curve_points);
    curve.ys.push_back(value(curve.xs.back()));
  }
  return curve;
}

/// Where the law ends.
Curve support_line(std::string label, double at, double value) {
  return {.label = std::move(label), .colour = ink::chosen, .xs = {at, at}, .ys = {0, value}, .dashed = true};
}

/// A kernel and what it weighs, distances over h. The curves have the volume V_0 = m/rho_0, bars their own.
class KernelAtWork {
 public:
  KernelAtWork(const KernelAround& around, const Fluid& fluid)
      : around_(around),
        volume_(fluid.mass / fluid.state.reference_density),
        mass_(fluid.mass),
        end_(beyond * around.support / around.h) {}

  /// V W: a bar for each neighbour.
  [[nodiscard]] Plot weights() const {
    auto plot = shares([&](double r) { return around_.value(r); }, volume_ * around_.value(0));
    plot.title = w().weight;
    return plot;
  }

  /// sum V W of all that are nearer than r: it ought to end at 1.
  [[nodiscard]] Plot sum(double own_density, double reference_density, const std::string& unit) const {
    std::vector<std::pair<double, double>> steps;
    double kernels = 0;
    for (const auto& other : around_.neighbours) {
      const double r = norm(other.separation), value = around_.value(r);
      steps.emplace_back(r / around_.h, other.volume * value);
      kernels += value;
    }
    std::ranges::sort(steps);
    Curve stairs{.label = say(w().density, fmt::arg("density", fmt::format("{:.1f}", mass_ * kernels)),
                              fmt::arg("unit", unit)),
                 .colour = of_sum(),
                 .xs = {0},
                 .ys = {0}};
    for (const auto& [at, share] : steps) {
      const double before = stairs.ys.back();
      stairs.xs.insert(stairs.xs.end(), {at, at});
      stairs.ys.insert(stairs.ys.end(), {before, before + share});
    }
    stairs.xs.push_back(end_);
    stairs.ys.push_back(stairs.ys.back());
    Plot plot{.title = say(w().sum, fmt::arg("sum", fmt::format("{:.3f}", stairs.ys.back()))),
              .x_label = "r/h",
              .y_label = {},
              .curves = {}};
    const auto densities = say(w().own_density, fmt::arg("own", fmt::format("{:.1f}", own_density)),
                               fmt::arg("reference", fmt::format("{:.4g}", reference_density)));
    plot.curves = {{.label = densities, .colour = of_law(), .xs = {0, end_}, .ys = {1, 1}, .dashed = true},
                   support_line({}, around_.support / around_.h, 1),
                   std::move(stairs)};
    return plot;
  }

  /// h V W': a bar for each neighbour, and the length of h sum V grad W, which ought to be 0.
  [[nodiscard]] Plot slopes() const {
    auto plot = shares([&](double r) { return around_.h * around_.slope(r); }, 0);
    Vector gradient{0, 0};
    for (const auto& [d, volume, wall] : around_.neighbours)
      if (const double r = norm(d); r > 0) gradient += volume * around_.slope(r) / r * d;
    plot.title = w().slope;
    plot.y_label = say(w().gradient, fmt::arg("sum", fmt::format("{:.3f}", around_.h * norm(gradient))));
    return plot;
  }

 private:
  /// V times `law`, as a curve and as bars.
  [[nodiscard]] Plot shares(const std::function<double(double)>& law, double height) const {
    Plot plot{.title = {}, .x_label = "r/h", .y_label = {}, .curves = {}};
    plot.curves = {support_line("2h", around_.support / around_.h, height),
                   law_curve(0, end_, [&](double q) { return volume_ * law(q * around_.h); })};
    Bars liquid{.label = std::string(w().fluid), .colour = of_liquid(), .xs = {}, .ys = {}};
    Bars walls{.label = std::string(w().wall), .colour = of_walls(), .xs = {}, .ys = {}};
    for (const auto& other : around_.neighbours) {
      auto& bars = other.wall ? walls : liquid;
      const double r = norm(other.separation);
      bars.xs.push_back(r / around_.h);
      bars.ys.push_back(other.volume * law(r));
    }
    plot.bars.push_back(std::move(liquid));
    if (!walls.xs.empty()) plot.bars.push_back(std::move(walls));
    return plot;
  }

  const KernelAround& around_;
  double volume_, mass_, end_;
};

/// Where a plot of the law of contact begins: discs overlap by a few per cent, unless the springs are soft.
double start_of_contact(const std::vector<double>& distances, double support) {
  const double nearest = distances.empty() ? support : std::ranges::min(distances);
  for (const double start : {0.95, 0.8})
    if (nearest > start * support) return start * support;
  return 0;
}

/// The force of a pair over the distance of their centres, and where the neighbours are on it.
Plot contact_plot(const Simulation& simulation, Model& model, Index i) {
  const auto& p = simulation.particles();
  const auto near = model.neighbourhood(p, i);
  const double m = p.mass(i), support = near->support;
  const auto force = [&](double r) { return m * model.push_at(r, i); };
  Plot plot{.title = std::string(w().contact),
            .x_label = "r [" + simulation.scene().length_unit + "]",
            .y_label = "F [" + printed(short_force_unit(simulation)) + "]",
            .curves = {}};
  Bars bars{.label = std::string(w().neighbours), .colour = of_liquid(), .xs = {}, .ys = {}};
  for (const auto j : near->neighbours) {
    bars.xs.push_back(norm(row(p.position, i) - row(p.position, j)));
    bars.ys.push_back(force(bars.xs.back()));
  }
  const double start = start_of_contact(bars.xs, support), end = support + (beyond - 1) * (support - start);
  plot.curves = {support_line("2 R", support, force(start)), law_curve(start, end, force)};
  plot.bars.push_back(std::move(bars));
  return plot;
}

}  // namespace

std::vector<Plot> kernel_plots(const Simulation& simulation, const System& system, Index particle) {
  if (!system.model.has_pairs()) return {};
  const auto around = system.model.kernel_around(particle);
  if (!around) return {contact_plot(simulation, system.model, particle)};
  const auto& fluid = *simulation.setup().fluid;
  const auto unit = printed(with_length("kg/L^3", simulation.scene().length_unit));
  const KernelAtWork kernel(*around, fluid);
  return {kernel.weights(), kernel.sum(system.density(particle), fluid.state.reference_density, unit),
          kernel.slopes()};
}

}  // namespace clapotis
