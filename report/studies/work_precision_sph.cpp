#include <algorithm>
#include <array>
#include <cmath>

#include "common/measures/energy.hpp"
#include "common/references/elliptical_drop.hpp"
#include "common/references/pysph.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/peers.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr std::string_view drop = "elliptical drop", water = "still water";

/// One departure from how a scene is set up, or none.
struct Setting {
  const char *varied, *name, *parameter, *value;
};
constexpr Setting as_it_is{"resolution", "default", "cfl", "1"};
constexpr std::array for_all{
    as_it_is,
    Setting{"integrator", "symplectic Euler", "integrator", "symplectic_euler"},
    Setting{"integrator", "explicit Euler", "integrator", "explicit_euler"},
    Setting{"integrator", "RK2", "integrator", "rk2"},
    Setting{"integrator", "RK4", "integrator", "rk4"},
    Setting{"CFL", "CFL 0.5", "cfl", "0.5"},
    Setting{"CFL", "CFL 1.4", "cfl", "1.4"},
    Setting{"h/dx", "h/dx 1.3", "h_over_dx", "1.3"},
};
// the drop: cubic spline, h/dx 1.5, density as a sum; the water: Wendland C2, h/dx 2, continuity
constexpr std::array for_drop{
    Setting{"kernel", "Wendland C2", "kernel", "wendland_c2"}, Setting{"h/dx", "h/dx 2", "h_over_dx", "2"},
    Setting{"density", "continuity", "density", "continuity"},
    Setting{"c", "c doubled", "sound_speed", "28"},  // 14 A0 R by default, as PySPH has it
};
constexpr std::array for_water{
    Setting{"kernel", "cubic spline", "kernel", "cubic_spline"},
    Setting{"h/dx", "h/dx 1.5", "h_over_dx", "1.5"}, Setting{"density", "summation", "density", "summation"},
    Setting{"c", "c doubled", "sound_speed", "88.6"},  // 10 sqrt(2gH) by default
};

/// What is found of a run. A drop has no pressure error, and water at rest no b.
struct Errors {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double b = none, b_largest = none;            ///< of the semi-axis, at the end and over the run
  double energy = none, energy_largest = none;  ///< of the kinetic energy
  double pressure_rms = none, pressure_largest = none, speed_largest = none;
};

std::vector<Row> found(const Errors& e, const Cost& cost, long particles) {
  return one_row(e.b, e.b_largest, e.energy, e.energy_largest, e.pressure_rms, e.pressure_largest,
                 e.speed_largest, cost.seconds.median, cost.seconds.spread, cost.steps, cost.evaluations,
                 particles);
}

constexpr double drop_ends = 0.76;  ///< t A0, where PySPH's example ends; A0 = 1/s, R = 1 m

std::vector<Row> measure_drop(const std::string& text, int times) {
  const auto start = simulation(text);
  const double kinetic = start->energy().kinetic;
  const auto stretch = start->setup().measures.front().value;  // by the outermost particle, as PySPH has it
  const EllipticalDrop exact{.radius = 1, .strain_rate = 1, .density = 1000};
  Errors e{.b_largest = 0, .energy_largest = 0};
  const auto cost = cost_until(text, drop_ends, times, [&](Simulation& run) {
    e.b = stretch(run.system()) / exact.at(run.time()).semi_axis_y - 1;
    e.energy = run.energy().kinetic / kinetic - 1;
    e.b_largest = std::max(e.b_largest, std::abs(e.b));
    e.energy_largest = std::max(e.energy_largest, std::abs(e.energy));
  });
  return found(e, cost, start->particles().size());
}

std::vector<Row> measure_water(const std::string& text, int times) {
  const double wave_speed = std::sqrt(9.81 * 1);  // of shallow water 1 m deep [m/s]
  Errors e{.pressure_rms = 0, .pressure_largest = 0, .speed_largest = 0};
  const auto cost = cost_until(text, 2, times, [&](Simulation& run) {
    const double error = run.error();
    e.pressure_rms += error * error;
    e.pressure_largest = std::max(e.pressure_largest, error);
    e.speed_largest = std::max(e.speed_largest, max_speed(run.particles()) / wave_speed);
  });
  e.pressure_rms = std::sqrt(e.pressure_rms / static_cast<double>(cost.steps));
  return found(e, cost, simulation(text)->particles().size());
}

Point point(std::string_view name, const Setting& setting, int cells, Effort effort) {
  const bool free = name == drop;
  const auto text = scene(free ? "stage4/elliptical_drop" : "stage4/still_water",
                          {{"spacing", to_text(1.0 / cells)}, {setting.parameter, setting.value}});
  const int times = effort == Effort::quick || cells >= 100 ? 1 : 3;
  return {.key = row(name, setting.varied, setting.name, cells),
          .measure = [=] { return free ? measure_drop(text, times) : measure_water(text, times); },
          .weight = times * (free ? 1.0 : 2.0) * std::pow(cells / 20.0, 3)};
}

std::vector<Row> published(const pysph::Drop& peer) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // only the end was published
  return found(
      {.b = peer.b_error, .b_largest = unknown, .energy = peer.energy_error, .energy_largest = unknown}, {},
      0);
}

std::vector<Row> measured(const PeerDrop& peer) {
  return found({.b = peer.b_error,
                .b_largest = peer.b_largest,
                .energy = peer.energy_error,
                .energy_largest = peer.energy_largest},
               {.seconds = {.median = peer.seconds}, .steps = peer.steps, .evaluations = peer.steps},
               peer.particles);
}

void add_peer(std::vector<Point>& all, Effort effort) {
  std::vector<int> resolutions;
  for (const auto& each : pysph::drops) {
    all.push_back({.key = row(drop, "PySPH", "as published", each.cells),
                   .measure = [=] { return published(each); },
                   .weight = 0.1});
    if (effort == Effort::full || each.cells == 20) resolutions.push_back(each.cells);
  }
  const auto run = run_pysph_drops(resolutions);
  for (const int cells : resolutions)
    all.push_back({.key = row(drop, "PySPH", "measured here", cells),
                   .measure =
                       [=] {
                         const auto peer = run(cells);  // nothing where it is not installed
                         return peer ? measured(*peer) : std::vector<Row>{};
                       },
                   .weight = 30 * std::pow(cells / 20.0, 3)});
}

std::vector<Point> points(Effort effort) {
  const bool full = effort == Effort::full;
  std::vector<Point> all;
  const auto add = [&](std::string_view name, const auto& settings, int cells) {
    for (const Setting& setting : settings) all.push_back(point(name, setting, cells, effort));
  };
  for (const int cells : {10, 20, 40, 80}) {
    if (cells == 80 && !full) break;
    add(drop, for_all, cells);
    add(drop, for_drop, cells);
  }
  for (const int cells : {25, 50}) {
    if (cells == 50 && !full) break;
    add(water, for_all, cells);
    add(water, for_water, cells);
  }
  all.push_back(point(water, as_it_is, full ? 100 : 50, effort));
  add_peer(all, effort);
  return all;
}

/// A row's setting and resolution: "CFL 1.4; 1/40".
std::string called(const Table& table, const Row& row) {
  return table.text(row, "setting") + (table.text(row, "case") == drop ? "; R/dx " : "; H/dx ") +
         table.text(row, "cells");
}

/// Our rows of a case; PySPH's are not among them.
std::vector<Row> ours(const Table& table, std::string_view name) {
  auto rows = table.where({{"case", name}});
  std::erase_if(rows, [&](const Row& row) { return table.text(row, "varied") == "PySPH"; });
  return rows;
}

struct Quantity {
  std::string_view of, column, name;
  double wanted;  ///< an error that one may want to be sure of
};
constexpr std::array quantities{Quantity{drop, "b_largest", "semi-axis b", 0.003},
                                Quantity{drop, "energy_largest", "kinetic energy", 0.01},
                                Quantity{water, "pressure_largest", "pressure", 0.01},
                                Quantity{water, "speed_largest", "speed", 0.02}};

/// The cheapest of some rows with an error of at most `wanted`; none where there is none.
Row cheapest(const Table& table, const std::vector<Row>& rows, std::string_view column, double wanted) {
  Row best;
  for (const auto& each : rows)
    if (table.number(each, column) <= wanted &&
        (best.empty() || table.number(each, "cpu") < table.number(best, "cpu")))
      best = each;
  return best;
}

TextTable front_of(const Table& table) {
  TextTable front{
      .name = "pareto", .header = {"case", "error of", "setting", "error [%]", "CPU time [s]"}, .rows = {}};
  for (const auto& each : quantities) {
    const auto rows = ours(table, each.of);
    const auto costs = table.numbers(rows, "cpu"), errors = table.numbers(rows, each.column);
    for (const auto k : pareto_front(costs, errors))
      front.rows.push_back({std::string(each.of), std::string(each.name), called(table, rows[k]),
                            rounded(100 * errors[k]), rounded(costs[k])});
  }
  return front;
}

void compare_with_peer(const Table& table, std::vector<Finding>& findings) {
  const auto peers = table.where({{"varied", "PySPH"}, {"setting", "measured here"}});
  findings.push_back({"pysph", peers.empty() ? "not installed" : "measured", "",
                      "PySPH side by side on this machine (./lab bench --peer pysph installs it)"});
  for (const auto& peer : peers) {
    const auto cells = table.text(peer, "cells");
    const auto same = table.where({{"case", drop}, {"setting", "default"}, {"cells", cells}});
    const auto best = cheapest(table, ours(table, drop), "b_largest", table.number(peer, "b_largest"));
    if (same.empty() || best.empty()) continue;
    const double seconds = table.number(peer, "cpu");
    findings.push_back({"pysph_b_" + cells, rounded(100 * table.number(peer, "b_error")), "%",
                        "error of b by PySPH, measured here, R/dx = " + cells});
    findings.push_back({"pysph_cpu_" + cells, rounded(seconds), "s", "what that took PySPH"});
    findings.push_back({"pysph_same_grid_" + cells, rounded(seconds / table.number(same[0], "cpu"), 2),
                        "times",
                        "CPU time of PySPH over ours on the same grid, our error " +
                            rounded(100 * table.number(same[0], "b_largest"), 2) + " %"});
    findings.push_back(
        {"pysph_same_error_" + cells, rounded(seconds / table.number(best, "cpu"), 2), "times",
         "CPU time of PySPH over the cheapest of ours that is as good: " + called(table, best)});
  }
}

Conclusion conclude(const Table& table) {
  Conclusion all{.findings = {}, .tables = {front_of(table)}};
  for (const auto& each : quantities) {
    const std::string name(each.column);
    const auto rows = ours(table, each.of);
    const auto best = cheapest(table, rows, each.column, each.wanted);
    const auto wanted = rounded(100 * each.wanted, 2) + " % of " + std::string(each.name);
    all.findings.push_back({name + "_best", best.empty() ? "none" : called(table, best), "",
                            "the cheapest that stays within " + wanted});
    all.findings.push_back(
        {name + "_best_cpu", best.empty() ? "-" : rounded(table.number(best, "cpu")), "s", "what it costs"});
    const auto plain = table.where({{"case", each.of}, {"setting", "default"}});
    const auto law = power_law(table.numbers(plain, "cpu"), table.numbers(plain, each.column));
    all.findings.push_back(
        {name + "_per_cpu", rounded(law.exponent, 2), "", "exponent of the default's error in CPU time"});
  }
  compare_with_peer(table, all.findings);
  return all;
}

}  // namespace

Study work_precision_sph() {
  return {.name = "work_precision_sph",
          .question =
              "What does an accurate liquid cost: which resolution, kernel, h/dx, density, "
              "integrator and CFL number for a wanted error?",
          .keys = {{"case", ""}, {"varied", ""}, {"setting", ""}, {"cells", "1"}},
          .values = {{"b_error", "1"},
                     {"b_largest", "1"},
                     {"energy_error", "1"},
                     {"energy_largest", "1"},
                     {"pressure_rms", "1"},
                     {"pressure_largest", "1"},
                     {"speed_largest", "sqrt(g H)"},
                     {"cpu", "s"},
                     {"cpu_spread", "1"},
                     {"steps", "1"},
                     {"evaluations", "1"},
                     {"particles", "1"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
