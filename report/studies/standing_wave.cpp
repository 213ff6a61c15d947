#include <array>
#include <cmath>
#include <numbers>

#include "common/references/waves.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

using std::numbers::pi;

/// Re = H sqrt(g H)/nu, of a liquid without viscosity a word; and how wide the kernel is. A lattice of
/// particles resists shear, the less the wider the kernel, however fine it is.
struct Liquid {
  const char* reynolds;
  double h_over_dx;
};
constexpr std::array liquids{Liquid{"inviscid", 2}, Liquid{"500", 2}, Liquid{"100", 2}, Liquid{"50", 2},
                             Liquid{"inviscid", 3}};
constexpr int of_curve = 40;  // H/dx of the swings that are drawn

/// Two periods: the wave as it goes, and its frequency and decay from the first half swing on, for the start
/// is at rest, which a decaying wave never is. The exact one is drawn from there on, too.
std::vector<Row> swing(const Liquid& liquid, int resolution) {
  const std::string reynolds = liquid.reynolds;
  const double depth = 1, gravity = 9.81, k = 2 * pi / depth;  // the scene's
  const bool viscous = reynolds != "inviscid";
  const double nu = viscous ? std::sqrt(gravity * depth) * depth / std::stod(reynolds) : 0;
  const auto exact =
      viscous ? viscous_wave(gravity, k, nu) : ViscousWave{wave_frequency(gravity, k, depth), 0};
  const auto wave = simulation(scene("stage5/standing_wave", {{"nu", to_text(nu)},
                                                              {"h_over_dx", to_text(liquid.h_over_dx)},
                                                              {"spacing", to_text(depth / resolution)}}));
  const double start = measure(*wave, "wave_amplitude"), period = 2 * pi / exact.frequency;
  Series heights;
  advance(*wave, 2 * period,
          [&](Simulation& run) { heights.add(run.time(), measure(run, "wave_amplitude") / start); });
  const auto tops = extremes(heights);
  if (tops.size() < 3) return one_row("run");
  const double half = (tops[2].t - tops[0].t) / 2;
  // One swing over the one before, which does not see by how much the lattice settles.
  const double decay = -std::log((tops[1].y - tops[2].y) / (tops[1].y - tops[0].y)) / half;
  const auto cost = cost_per_second(*wave);
  const double nothing = std::nan("");
  std::vector<Row> rows{row("run", nothing, nothing, nothing, pi / half, exact.frequency, decay, exact.decay,
                            std::abs(pi / half / exact.frequency - 1), std::abs(decay / exact.decay - 1),
                            cost.median, cost.spread)};
  if (resolution != of_curve) return rows;
  // about which it swings once the lattice has settled: of tops that shrink evenly
  const double level =
      (tops[0].y * tops[2].y - tops[1].y * tops[1].y) / (tops[0].y + tops[2].y - 2 * tops[1].y);
  double next = 0;
  for (std::size_t i = 0; i < heights.t.size(); ++i) {
    const double t = heights.t[i], since = t - tops[0].t;
    if (t < next) continue;
    next += period / 50;
    const double now =
        std::exp(-exact.decay * since) * (std::cos(exact.frequency * since) +
                                          exact.decay / exact.frequency * std::sin(exact.frequency * since));
    rows.push_back(
        row("curve", t / period, heights.y[i], since < 0 ? nothing : level + (tops[0].y - level) * now));
  }
  return rows;
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const int resolution : {20, 30, 40, 60, 80, 120}) {
    if (effort == Effort::quick && resolution > of_curve) break;
    for (const auto& liquid : liquids)
      if (liquid.h_over_dx == 2 || resolution <= 80)
        all.push_back({.key = row(liquid.reynolds, liquid.h_over_dx, resolution),
                       .measure = [=] { return swing(liquid, resolution); },
                       .weight = std::pow(resolution / 20.0, 3) * liquid.h_over_dx});
  }
  return all;
}

Conclusion conclude(const Table& table) {
  TextTable result{
      .name = "errors", .header = {"Re", "h/dx", "H/dx", "frequency", "decay", "CPU s per s"}, .rows = {}};
  std::vector<Finding> findings;
  double worst_frequency = 0, worst_decay = 0;
  for (const auto& liquid : liquids) {
    const auto width = cell(liquid.h_over_dx);
    const auto runs = table.where({{"part", "run"}, {"Re", liquid.reynolds}, {"h_over_dx", width}});
    if (runs.empty()) continue;
    const auto& best = runs.back();
    const double frequency = table.number(best, "frequency") / table.number(best, "exact_frequency"),
                 decay = table.number(best, "decay") / table.number(best, "exact_decay");
    result.rows.push_back({liquid.reynolds, width, table.text(best, "H_over_dx"), rounded(frequency, 4),
                           rounded(decay), rounded(table.number(best, "seconds"), 2)});
    if (std::string_view(liquid.reynolds) != "inviscid") {
      worst_frequency = greater(worst_frequency, table.number(best, "frequency_error"));
      worst_decay = greater(worst_decay, table.number(best, "decay_error"));
      continue;
    }
    findings.push_back({"inviscid_" + width, rounded(100 * (frequency - 1), 2), "%",
                        "error of the frequency without viscosity, h/dx = " + width +
                            ", H/dx = " + table.text(best, "H_over_dx")});
    findings.push_back({"numerical_decay_" + width, rounded(table.number(best, "decay"), 2), "1/s",
                        "decay where there should be none, with h/dx = " + width});
  }
  findings.push_back({"frequency_error", rounded(100 * worst_frequency, 2), "%",
                      "largest error of a viscous wave's frequency, finest spacing"});
  findings.push_back({"decay_error", rounded(100 * worst_decay, 2), "%", "and of its decay"});
  return {.findings = findings, .tables = {result}};
}

}  // namespace

Study standing_wave() {
  return {.name = "standing_wave",
          .question = "How fast does a standing wave swing and die away, against linear theory?",
          .keys = {{"Re", "1"}, {"h_over_dx", "1"}, {"H_over_dx", "1"}},
          .values = {{"part", ""},
                     {"periods", "1"},
                     {"amplitude", "1"},
                     {"exact_amplitude", "1"},
                     {"frequency", "1/s"},
                     {"exact_frequency", "1/s"},
                     {"decay", "1/s"},
                     {"exact_decay", "1/s"},
                     {"frequency_error", "1"},
                     {"decay_error", "1"},
                     {"seconds", "s/s"},
                     {"spread", "1"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
