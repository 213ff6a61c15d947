#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/references/capillarity.hpp"
#include "report/studies/flows.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

using std::numbers::pi;

// The scenes' own: a drop of water.
constexpr double radius = 1e-3, sigma = 0.072, rho = 1000;
constexpr double millisecond = 1e-3;
constexpr int of_curve = 25;  // R/dx of the swing that is drawn
const double nothing = std::nan("");

struct Drop {
  int resolution;  ///< R/dx
  double h_over_dx;
  [[nodiscard]] std::string text(const std::string& name,
                                 std::vector<std::pair<std::string, std::string>> more) const {
    more.insert(more.end(), {{"spacing", to_text(radius / resolution)}, {"h_over_dx", to_text(h_over_dx)}});
    return scene("stage5/" + name, more);
  }
};

/// The radius of the round drop that its particles make.
double radius_of(const Simulation& run) {
  return std::sqrt(static_cast<double>(run.particles().size()) / pi) * run.parameters().value("spacing");
}

double fastest(const Simulation& run) {
  return std::sqrt(run.particles().velocity.square().rowwise().sum().maxCoeff());
}

/// A round drop at rest: the pressure inside, mean from 10 to 50 ms, and what still moves, rms from 40 ms on.
std::vector<Row> at_rest(const Drop& drop) {
  const double nu = 5e-5;
  const auto run = simulation(drop.text("capillary_drop", {{"deformation", "0"}, {"nu", to_text(nu)}}));
  advance(*run, 10 * millisecond);
  const double exact = laplace_jump(sigma, radius_of(*run));
  double jumps = 0, count = 0, squares = 0, late = 0;
  for (int k = 1; k <= 80; ++k) {
    advance(*run, (10 + 0.5 * k) * millisecond);
    jumps += measure(*run, "pressure_jump") / exact, ++count;
    if (run->time() > 39.9 * millisecond) squares += std::pow(fastest(*run), 2), ++late;
  }
  const double speed = std::sqrt(squares / late), jump = jumps / count;
  const auto cost = cost_per_second(*run);
  return one_row("run", nothing, nothing, nothing, run->particles().size(), jump, std::abs(jump - 1),
                 speed / std::sqrt(sigma / (rho * radius)), rho * nu * speed / sigma, nothing, nothing,
                 nothing, cost.median, cost.spread);
}

/// The largest of |y| between two instants.
double largest_between(const Series& series, double from, double to) {
  double most = 0;
  for (std::size_t k = 0; k < series.t.size(); ++k)
    if (series.t[k] > from && series.t[k] < to) most = std::max(most, std::abs(series.y[k]));
  return most;
}

/// A drop that begins 5 % too long: two periods, from its first passage through the circle on.
std::vector<Row> swinging(const Drop& drop) {
  const auto run = simulation(drop.text("capillary_drop", {}));
  const DropMode exact{
      .radius = radius_of(*run), .density = rho, .sigma = sigma, .viscosity = run->parameters().value("nu")};
  const double deformation = run->parameters().value("deformation"), period = 2 * pi / exact.frequency();
  std::vector<Row> curve;
  Series swing;
  double next = 0;
  advance(*run, 2.5 * period, [&](Simulation& now) {
    swing.add(now.time(), std::log(measure(now, "stretch")) / (2 * deformation));
    if (now.time() < next) return;
    next += period / 50;
    curve.push_back(row("curve", now.time() / millisecond, swing.y.back(), exact.at(now.time())));
  });
  const auto cost = cost_per_second(*run);
  double ratio = nothing, decay = nothing;
  if (const auto passages = zeros(swing); passages.size() >= 5) {
    ratio = (passages[4] - passages[0]) / 2 / period;
    // of tops that are three half swings apart
    decay = std::log(largest_between(swing, passages[0], passages[1]) /
                     largest_between(swing, passages[3], passages[4])) /
            (1.5 * ratio * period) / exact.decay();
  }
  std::vector<Row> rows{row("run", nothing, nothing, nothing, run->particles().size(), nothing,
                            std::abs(ratio - 1), nothing, nothing, ratio, decay, nothing, cost.median,
                            cost.spread)};
  if (drop.resolution == of_curve) rows.insert(rows.end(), curve.begin(), curve.end());
  return rows;
}

/// Half a disc on a plate: its angle, mean from 20 to 30 ms.
std::vector<Row> on_plate(const Drop& drop, double wanted) {
  const auto run = simulation(drop.text("sessile_drop", {{"contact_angle", to_text(wanted)}}));
  advance(*run, 20 * millisecond);
  double sum = 0, count = 0;
  for (int k = 1; k <= 20; ++k) {
    advance(*run, (20 + 0.5 * k) * millisecond);
    sum += measure(*run, "measured_angle"), ++count;
  }
  const double angle = sum / count;
  const auto cost = cost_per_second(*run);
  return one_row("run", nothing, nothing, nothing, run->particles().size(), nothing,
                 std::abs(angle / wanted - 1), nothing, nothing, nothing, nothing, angle, cost.median,
                 cost.spread);
}

constexpr std::array angles{"60", "90", "120"};

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  const auto add = [&](const std::string& name, const Drop& drop, auto measure) {
    all.push_back({.key = row(name, drop.resolution, drop.h_over_dx),
                   .measure = measure,
                   .weight = std::pow(drop.resolution / 10.0, 3.5) * drop.h_over_dx / 3});
  };
  for (const int resolution : {10, 15, 25, 35, 50}) {
    if (effort == Effort::quick && resolution > 25) break;
    const Drop drop{resolution, 3};
    add("round", drop, [=] { return at_rest(drop); });
    add("swinging", drop, [=] { return swinging(drop); });
    if (resolution <= 35)
      for (const std::string angle : angles)
        add("plate " + angle, drop, [=] { return on_plate(drop, std::stod(angle)); });
    if (resolution < 25 || effort == Effort::quick) continue;
    const Drop wide{resolution, 4};
    add("swinging", wide, [=] { return swinging(wide); });
  }
  return all;
}

Conclusion conclude(const Table& table) {
  TextTable result{
      .name = "drops",
      .header = {"R/dx", "h/dx", "jump", "Ca", "period", "decay", "60", "90", "120", "CPU s per ms"},
      .rows = {}};
  for (const auto& resolution : table.kinds("R_over_dx")) {
    for (const auto& width : table.kinds("h_over_dx")) {
      const auto of = [&](const std::string& name, std::string_view column, int digits = 3) {
        const auto runs =
            table.where({{"case", name}, {"R_over_dx", resolution}, {"h_over_dx", width}, {"part", "run"}});
        return runs.empty() ? std::string("-") : rounded(table.number(runs[0], column), digits);
      };
      const auto swinging = table.where(
          {{"case", "swinging"}, {"R_over_dx", resolution}, {"h_over_dx", width}, {"part", "run"}});
      if (swinging.empty()) continue;
      result.rows.push_back({resolution, width, of("round", "jump"), of("round", "capillary_number", 2),
                             of("swinging", "period_ratio"), of("swinging", "decay_ratio"),
                             of("plate 60", "angle"), of("plate 90", "angle"), of("plate 120", "angle"),
                             rounded(millisecond * table.number(swinging[0], "seconds"), 2)});
    }
  }
  std::vector<Finding> findings;
  const auto error = [&](const std::string& name, const std::string& resolution, const std::string& width) {
    const auto runs =
        table.where({{"case", name}, {"R_over_dx", resolution}, {"h_over_dx", width}, {"part", "run"}});
    return runs.empty() ? std::string("-") : rounded(100 * table.number(runs[0], "error"), 2);
  };
  findings.push_back(
      {"jump_error", error("round", "25", "3"), "%", "error of the pressure jump with R/dx = 25"});
  findings.push_back(
      {"period_error", error("swinging", "25", "3"), "%", "error of the period with R/dx = 25"});
  findings.push_back({"fine_period_error", error("swinging", "50", "3"), "%", "the same with R/dx = 50"});
  findings.push_back(
      {"wide_period_error", error("swinging", "50", "4"), "%", "the same with R/dx = 50 and h/dx = 4"});
  double most = 0;
  for (const std::string angle : angles)
    for (const auto& each : table.where({{"case", "plate " + angle}, {"R_over_dx", "25"}}))
      most = greater(most, std::abs(table.number(each, "angle") - std::stod(angle)));
  findings.push_back(
      {"angle_error", rounded(most, 2), "deg", "largest error of the contact angle with R/dx = 25"});
  const auto round = table.where({{"case", "round"}, {"part", "run"}});
  findings.push_back(
      {"cost_order",
       rounded(power_law(table.numbers(round, "R_over_dx"), table.numbers(round, "seconds")).exponent, 2), "",
       "a simulated second costs (R/dx) to the power"});
  return {.findings = findings, .tables = {result}};
}

}  // namespace

Study capillarity() {
  return {
      .name = "capillarity",
      .question =
          "How near do drops come to the pressure of Laplace, the period of Rayleigh, the angle of Young?",
      .keys = {{"case", ""}, {"R_over_dx", "1"}, {"h_over_dx", "1"}},
      .values = {{"part", ""},
                 {"t", "ms"},
                 {"swing", "1"},
                 {"exact_swing", "1"},
                 {"particles", "1"},
                 {"jump", "1"},
                 {"error", "1"},
                 {"parasitic_speed", "1"},
                 {"capillary_number", "1"},
                 {"period_ratio", "1"},
                 {"decay_ratio", "1"},
                 {"angle", "deg"},
                 {"seconds", "s/s"},
                 {"spread", "1"}},
      .points = points,
      .conclude = conclude};
}

}  // namespace clapotis::studies
