#include <array>
#include <cmath>
#include <numbers>

#include "common/references/waves.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

using std::numbers::pi;

/// H sqrt(g H)/nu; of a liquid without viscosity a word.
constexpr std::array reynolds_numbers{"inviscid", "500", "100", "50"};
constexpr int of_curve = 40;  // H/dx of the swings that are drawn

/// Two periods: the wave as it goes, and its frequency and decay from the first half swing on, for the start
/// is at rest, which a decaying wave never is. The exact one is drawn from there on, too.
std::vector<Row> swing(const std::string& reynolds, int resolution) {
  const double depth = 1, gravity = 9.81, k = 2 * pi / depth;  // the scene's
  const bool viscous = reynolds != "inviscid";
  const double nu = viscous ? std::sqrt(gravity * depth) * depth / std::stod(reynolds) : 0;
  const auto exact =
      viscous ? viscous_wave(gravity, k, nu) : ViscousWave{wave_frequency(gravity, k, depth), 0};
  const auto wave = simulation(
      scene("stage5/standing_wave", {{"nu", to_text(nu)}, {"spacing", to_text(depth / resolution)}}));
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
  double next = 0;
  for (std::size_t i = 0; i < heights.t.size(); ++i) {
    const double t = heights.t[i], since = t - tops[0].t;
    if (t < next) continue;
    next += period / 50;
    const double now =
        std::exp(-exact.decay * since) * (std::cos(exact.frequency * since) +
                                          exact.decay / exact.frequency * std::sin(exact.frequency * since));
    rows.push_back(row("curve", t / period, heights.y[i], since < 0 ? nothing : tops[0].y * now));
  }
  return rows;
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const int resolution : {20, 30, 40, 60, 80, 120}) {
    if (effort == Effort::quick && resolution > of_curve) break;
    for (const std::string reynolds : reynolds_numbers)
      all.push_back({.key = row(reynolds, resolution),
                     .measure = [=] { return swing(reynolds, resolution); },
                     .weight = std::pow(resolution / 20.0, reynolds.size() < 4 ? 4 : 3)});
  }
  return all;
}

std::string order(const std::vector<double>& resolutions, const std::vector<double>& errors) {
  return rounded(-power_law(resolutions, errors).exponent, 2);
}

std::string percent(double error) { return rounded(100 * error, 2); }

Conclusion conclude(const Table& table) {
  TextTable result{.name = "errors",
                   .header = {"Re", "H/dx", "frequency error [%]", "its order", "decay error [%]",
                              "its order", "CPU s per s"},
                   .rows = {}};
  double worst_frequency = 0, worst_decay = 0;
  std::string finest;
  for (const std::string reynolds : reynolds_numbers) {
    const auto runs = table.where({{"part", "run"}, {"Re", reynolds}});
    if (runs.empty()) continue;
    const auto resolutions = table.numbers(runs, "H_over_dx"),
               frequencies = table.numbers(runs, "frequency_error"),
               decays = table.numbers(runs, "decay_error");
    const auto& best = runs.back();
    finest = table.text(best, "H_over_dx");
    worst_frequency = std::max(worst_frequency, frequencies.back());
    if (std::isfinite(decays.back())) worst_decay = std::max(worst_decay, decays.back());
    result.rows.push_back({reynolds, finest, percent(frequencies.back()), order(resolutions, frequencies),
                           percent(decays.back()), order(resolutions, decays),
                           rounded(table.number(best, "seconds"), 2)});
  }
  const auto inviscid = table.where({{"part", "run"}, {"Re", "inviscid"}});
  const auto numerical = inviscid.empty() ? std::nan("") : table.number(inviscid.back(), "decay");
  return {.findings = {{"resolution", finest, "", "H/dx of the finest runs"},
                       {"frequency_error", percent(worst_frequency), "%",
                        "largest error of the frequency there, of all Re"},
                       {"decay_error", percent(worst_decay), "%", "largest error of the decay there"},
                       {"numerical_decay", rounded(numerical, 2), "1/s", "decay where there should be none"}},
          .tables = {result}};
}

}  // namespace

Study standing_wave() {
  return {.name = "standing_wave",
          .question = "How fast does a standing wave swing and die away, against linear theory?",
          .keys = {{"Re", "1"}, {"H_over_dx", "1"}},
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
