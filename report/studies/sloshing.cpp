#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/laws/tank_motion.hpp"
#include "common/references/waves.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

using std::numbers::pi;

constexpr std::array scenes{"sloshing", "rolling"};
constexpr std::array drawn{10, 40};  // H/dx of the waves that are drawn

/// What linear theory says of the tank of a run.
MovedTank linear_theory(const Simulation& run) {
  auto p = run.parameters();
  const auto motion = TankMotion::from(p);
  return {p.value("tank_width"), p.value("depth"), motion.gravity,
          motion.amplitude,      motion.angle,     motion.omega};
}

/// The share of the first mode in the surface, eta = b cos(pi x/L) + ...: the integral of the mode over the
/// water.
double first_mode(const Simulation& run, double width) {
  const auto& p = run.particles();
  return 2 / width * p.uniform_mass * ((pi / width * p.position.col(0)).cos() / p.density).sum();
}

/// Three natural periods from rest: the surface at the left wall against linear theory (half of left less
/// right, as the scene's own error), and the frequency with which the first mode swings by itself.
std::vector<Row> transient(const std::string& name, int resolution) {
  constexpr double depth = 0.5;  // the scene's
  const auto tank = simulation(scene("stage5/" + name, {{"spacing", to_text(depth / resolution)}}));
  const auto exact = linear_theory(*tank);
  const double natural = exact.natural_frequency(1), period = 2 * pi / natural,
               greatest = exact.greatest(3 * period);
  const bool curve = std::find(drawn.begin(), drawn.end(), resolution) != drawn.end();
  std::vector<Row> rows;
  Series mode;
  double most = 0, squares = 0, next = 0;
  advance(*tank, 3 * period, [&](Simulation& run) {
    const double error = run.error();
    most = std::max(most, error);
    squares += error * error;
    mode.add(run.time(), first_mode(run, exact.width));
    if (!curve || run.time() < next) return;
    next += period / 50;
    rows.push_back(row("curve", run.time() / period,
                       (measure(run, "elevation_left") - measure(run, "elevation_right")) / 2 / greatest,
                       exact.elevation(0, run.time()) / greatest));
  });
  const double frequency = free_frequency(mode, natural, exact.omega);
  const double rms = std::sqrt(squares / static_cast<double>(tank->steps()));
  const auto cost = cost_per_second(*tank);
  const double nothing = std::nan("");
  rows.insert(rows.begin(),
              row("run", nothing, nothing, nothing, tank->particles().size(), most, rms, frequency / natural,
                  std::abs(frequency / natural - 1), cost.median, cost.spread));
  return rows;
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const int resolution : {10, 20, 30, 40, 60, 80}) {
    if (effort == Effort::quick && (resolution > 40 || resolution == 30)) continue;
    for (const std::string name : scenes)
      all.push_back({.key = row(name, resolution),
                     .measure = [=] { return transient(name, resolution); },
                     .weight = std::pow(resolution / 10.0, 3)});
  }
  return all;
}

Conclusion conclude(const Table& table) {
  TextTable result{
      .name = "errors",
      .header = {"scene", "H/dx", "largest error [%]", "rms error [%]", "frequency", "CPU s per s"},
      .rows = {}};
  std::vector<Finding> findings;
  double off = 0;
  for (const std::string name : scenes) {
    const auto runs = table.where({{"part", "run"}, {"scene", name}});
    if (runs.empty()) continue;
    for (const auto& run : runs) {
      result.rows.push_back(
          {name, table.text(run, "H_over_dx"), rounded(100 * table.number(run, "largest_error"), 2),
           rounded(100 * table.number(run, "rms_error"), 2), rounded(table.number(run, "frequency_ratio"), 5),
           rounded(table.number(run, "seconds"), 2)});
    }
    off = greater(off, table.number(runs.back(), "frequency_error"));
    const auto order = power_law(table.numbers(runs, "H_over_dx"), table.numbers(runs, "largest_error"));
    findings.push_back(
        {name + "_order", rounded(-order.exponent, 2), "", name + ": order in dx of the largest error"});
    findings.push_back({name + "_error", rounded(100 * table.number(runs.back(), "largest_error"), 2), "%",
                        name + ": largest error with H/dx = " + table.text(runs.back(), "H_over_dx")});
  }
  findings.push_back({"frequency_error", rounded(100 * off, 2), "%",
                      "largest error of the natural frequency with the finest spacing"});
  return {.findings = findings, .tables = {result}};
}

}  // namespace

Study sloshing() {
  return {.name = "sloshing",
          .question = "How near does water in a tank that sways or rolls come to linear theory?",
          .keys = {{"scene", ""}, {"H_over_dx", "1"}},
          .values = {{"part", ""},
                     {"periods", "1"},
                     {"elevation", "1"},
                     {"exact_elevation", "1"},
                     {"particles", "1"},
                     {"largest_error", "1"},
                     {"rms_error", "1"},
                     {"frequency_ratio", "1"},
                     {"frequency_error", "1"},
                     {"seconds", "s/s"},
                     {"spread", "1"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
