#include <array>
#include <cmath>

#include "report/studies/conclusion.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

/// A ball that falls from 1 m, with or without drag; the longer run meets the floor three times.
struct Case {
  const char *name, *drag, *impacts;
  double until;  ///< [s]
};
constexpr std::array cases{
    Case{"fall with drag", "1", "located", 0.4}, Case{"fall without drag", "0", "located", 0.4},
    Case{"clamped bounces", "1", "clamp", 1.6}, Case{"located bounces", "1", "located", 1.6}};
constexpr std::array schemes{"explicit_euler", "symplectic_euler", "velocity_verlet", "rk2", "rk4"};

/// Root mean square over the run: at one instant errors of either sign may cancel.
double rms_error(const std::string& text, double until) {
  const auto ball = simulation(text);
  double sum = 0;
  advance(*ball, until, [&](Simulation& run) { sum += run.error() * run.error(); });
  return std::sqrt(sum / static_cast<double>(ball->steps()));
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const auto& each : cases)
    for (const char* scheme : schemes)
      for (int steps = 16; steps <= (effort == Effort::quick ? 1024 : 16384); steps *= 2) {
        const double dt = each.until / steps;
        const auto text = scene(
            "stage1/drop",
            {{"drag", each.drag}, {"impacts", each.impacts}, {"integrator", scheme}, {"dt", to_text(dt)}});
        all.push_back({.key = row(each.name, scheme, dt),
                       .measure = [=, until = each.until] { return one_row(rms_error(text, until)); },
                       .weight = steps / 16.0});
      }
  return all;
}

/// Fitted where it is neither round-off nor the coarsest steps.
std::string order(const Table& table, std::string_view name, std::string_view scheme) {
  std::vector<double> steps, errors;
  for (const auto& each : table.where({{"case", name}, {"scheme", scheme}})) {
    const double error = table.number(each, "error");
    if (error < 1e-13 || table.number(each, "dt") > 0.05) continue;
    steps.push_back(table.number(each, "dt"));
    errors.push_back(error);
  }
  return steps.size() < 3 ? "exact" : rounded(power_law(steps, errors).exponent);
}

Conclusion conclude(const Table& table) {
  TextTable orders{.name = "orders", .header = {"scheme"}, .rows = {}};
  for (const auto& each : cases) orders.header.emplace_back(each.name);
  for (const char* scheme : schemes) {
    orders.rows.push_back({spoken(scheme)});
    for (const auto& each : cases) orders.rows.back().push_back(order(table, each.name, scheme));
  }
  return {.findings = {{"rk4_clamped", order(table, cases[2].name, "rk4"), "",
                        "order of RK4 with clamped impacts"},
                       {"rk4_located", order(table, cases[3].name, "rk4"), "",
                        "order of RK4 with located impacts"}},
          .tables = {orders}};
}

}  // namespace

Study orders() {
  return {.name = "orders",
          .question = "How does the error of a bouncing ball fall with the time step, for each integrator?",
          .keys = {{"case", ""}, {"scheme", ""}, {"dt", "s"}},
          .values = {{"error", "m"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
