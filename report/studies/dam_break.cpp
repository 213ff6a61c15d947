#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "common/laws/dummy_walls.hpp"
#include "common/references/dam_break_front.hpp"
#include "common/references/pysph.hpp"
#include "common/runner/stopwatch.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

constexpr double a = 1, tank = 4 * a;                   ///< widths of the column and the tank [m]
constexpr double gravity = 9.81;                        ///< [m/s^2]
constexpr double probe_height = 0.2 * a;                ///< the probe is the foot of the far wall, up to here
constexpr double last = 8, every = 0.05;                ///< T
constexpr std::array resolutions{16, 32, 64, 128};      ///< a/dx
const double time_unit = std::sqrt(a / (2 * gravity));  ///< of T = t sqrt(2g/a) [s]

/// Mean pressure on the foot of the far wall, of the particles that are its face [Pa].
double wall_pressure(const Simulation& run) {
  const auto& wall = *run.model().wall_particles();
  const double dx = run.setup().fluid->spacing;
  double sum = 0, count = 0;
  for (Index slot = 0; slot < wall.size(); ++slot) {
    const auto r = wall.columns.position(slot);
    if (r.x < tank || r.x > tank + dx || r.y < 0 || r.y > probe_height) continue;
    sum += wall.columns.pressure(slot);
    count += 1;
  }
  return sum / count;
}

/// Every 0.05 of T: the front, the mean pressure since the last row, as a probe of that response time has it,
/// and where the energy is. Units: a, rho_0 g a, the potential energy at the start.
std::vector<Row> flow(int cells) {
  const auto run = simulation(scene("stage4/dam_break", {{"spacing", to_text(a / cells)}}));
  const auto front = run->setup().measures.front().value;
  const auto start = run->energy();
  const double pressure_unit = run->setup().fluid->state.reference_density * gravity * a;
  std::vector<Row> rows;
  double seconds = 0;
  for (int k = 0; k * every <= last + 1e-9; ++k) {
    double impulse = 0, before = run->time(), resumed = processor_seconds();
    const double from = before;
    advance(*run, k * every * time_unit, [&](Simulation& s) {
      seconds += processor_seconds() - resumed;
      impulse += wall_pressure(s) * (s.time() - before);
      before = s.time();
      resumed = processor_seconds();
    });
    const double pressure = k > 0 ? impulse / (run->time() - from) : 0;
    const auto e = run->energy();
    rows.push_back(row(k * every, front(run->system()) / a, pressure / pressure_unit,
                       e.kinetic / start.potential, e.potential / start.potential,
                       (e.internal - start.internal) / start.potential, e.dissipated / start.potential,
                       (e.total() - start.total()) / start.potential, seconds));
  }
  return rows;
}

/// Rows that hold a front alone.
std::vector<Row> fronts_alone(const std::vector<FrontReading>& readings) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Row> rows;
  for (const auto& each : readings)
    rows.push_back(row(each.time, each.front, none, none, none, none, none, none, none));
  return rows;
}

/// As a cell of a table: without the comma.
std::string label(const FrontExperiment& experiment) {
  std::string text(experiment.name);
  const auto comma = text.find(", a");
  return comma == std::string::npos ? text : text.substr(0, comma) + " (" + text.substr(comma + 2) + ")";
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const auto& experiment : dam_break_fronts)
    all.push_back({.key = row("experiment", label(experiment), 0),
                   .measure =
                       [&] {
                         return fronts_alone({experiment.readings.begin(), experiment.readings.end()});
                       },
                   .weight = 0.01});
  for (const int cells : {32, 50})
    all.push_back({.key = row("peer", "PySPH", cells),
                   .measure =
                       [=] {
                         std::vector<FrontReading> readings;
                         for (const auto& each : pysph::fronts)
                           readings.push_back({each.time, cells == 32 ? each.coarse : each.fine});
                         return fronts_alone(readings);
                       },
                   .weight = 0.01});
  for (const int cells : resolutions)
    if (cells <= 32 || effort == Effort::full)
      all.push_back({.key = row("ours", "dam break", cells),
                     .measure = [=] { return flow(cells); },
                     .weight = std::pow(cells / 16.0, 3)});
  return all;
}

/// A column of some rows at T, linear between them.
double at(const Table& table, const std::vector<Row>& rows, std::string_view column, double T) {
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double before = table.number(rows[k - 1], "T"), after = table.number(rows[k], "T");
    if (T < before || T > after) continue;
    return std::lerp(table.number(rows[k - 1], column), table.number(rows[k], column),
                     (T - before) / (after - before));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// By how much a front (ours is the edge of the foremost particle, PySPH's its centre) leads an experiment,
/// in a: the mean over the instants at which the peer's is known too, as far as the experiment has readings.
double lead(const FrontExperiment& experiment, const std::function<double(double)>& front) {
  double sum = 0, count = 0;
  for (const auto& each : pysph::fronts) {
    const double ahead = front(each.time) - experiment.front(each.time);
    if (!std::isfinite(ahead)) continue;
    sum += ahead;
    count += 1;
  }
  return sum / count;
}

Row largest(const Table& table, const std::vector<Row>& rows, std::string_view column) {
  return *std::max_element(rows.begin(), rows.end(), [&](const Row& one, const Row& other) {
    return table.number(one, column) < table.number(other, column);
  });
}

/// Of one resolution: leads, what the wall feels, and what becomes of the energy.
std::vector<Finding> findings_of(const Table& table, const std::vector<Row>& rows, const std::string& cells) {
  std::vector<Finding> all;
  const auto found = [&](const std::string& name, double value, const char* unit, const std::string& meaning,
                         int digits = 3) {
    all.push_back({name + "_" + cells, rounded(value, digits), unit, meaning + ", a/dx = " + cells});
  };
  const auto front = [&](double T) { return at(table, rows, "front", T); };
  found("lead_koshizuka", lead(koshizuka_oka_1996, front), "a", "mean lead over Koshizuka & Oka at four T",
        2);
  found("lead_martin_small", lead(martin_moyce_1952_small, front), "a",
        "mean lead over Martin & Moyce with a = 2.86 cm", 2);
  found("lead_martin_large", lead(martin_moyce_1952_large, front), "a",
        "mean lead over Martin & Moyce with a = 5.72 cm", 2);
  const auto peak = largest(table, rows, "wall_pressure");
  found("peak_pressure", table.number(peak, "wall_pressure"), "",
        "greatest pressure on the foot of the far wall, over rho g a");
  found("peak_time", table.number(peak, "T"), "", "T of it");
  double drift = 0;
  for (const auto& each : rows) drift = greater(drift, std::abs(table.number(each, "drift")));
  found("drift", drift, "", "largest drift of the total energy until T = 8, of the potential at the start",
        2);
  found("dissipated_3", 100 * at(table, rows, "dissipated", 3), "%", "energy dissipated by T = 3", 2);
  found("dissipated_8", 100 * at(table, rows, "dissipated", 8), "%", "energy dissipated by T = 8", 2);
  found("cpu", table.number(rows.back(), "cpu"), "s", "processor time to T = 8, 1.8 s of water", 2);
  return all;
}

Conclusion conclude(const Table& table) {
  Conclusion all{.findings = {},
                 .tables = {{.name = "fronts", .header = {"front x/a at T ="}, .rows = {}},
                            {.name = "resolutions",
                             .header = {"a/dx", "lead [a]", "peak [rho g a]", "drift", "lost to T = 3 [%]",
                                        "lost to T = 8 [%]", "CPU s"},
                             .rows = {}}}};
  auto& fronts = all.tables.front();
  for (const auto& each : pysph::fronts) fronts.header.push_back(rounded(each.time));
  const auto line = [&](const std::string& name, const std::function<double(double)>& front) {
    fronts.rows.push_back({name});
    for (const auto& each : pysph::fronts) fronts.rows.back().push_back(rounded(front(each.time), 4));
  };
  std::vector<Row> coarser;
  for (const int resolution : resolutions) {
    const auto cells = std::to_string(resolution);
    const auto rows = table.where({{"what", "ours"}, {"cells", cells}});
    if (rows.empty() || table.diverged(rows.front())) continue;
    const auto front = [&](double T) { return at(table, rows, "front", T); };
    line("ours; a/dx " + cells, front);
    const auto found = findings_of(table, rows, cells);
    all.findings.insert(all.findings.end(), found.begin(), found.end());
    auto& line_of_it = all.tables.back().rows.emplace_back(Row{cells});
    for (const char* name :
         {"lead_koshizuka", "peak_pressure", "drift", "dissipated_3", "dissipated_8", "cpu"})
      for (const auto& each : found)
        if (each.name == name + ('_' + cells)) line_of_it.push_back(each.value);
    double apart = 0;
    for (const auto& each : pysph::fronts)
      apart = greater(apart, std::abs(front(each.time) - at(table, coarser, "front", each.time)));
    if (!coarser.empty())
      all.findings.push_back({"apart_" + cells, rounded(apart, 2), "a",
                              "largest distance of the fronts with a/dx = " + cells + " and half of that"});
    coarser = rows;
  }
  for (const char* cells : {"32", "50"}) {
    const auto rows = table.where({{"what", "peer"}, {"cells", cells}});
    const auto front = [&](double T) { return at(table, rows, "front", T); };
    line(std::string("PySPH; a/dx ") + cells, front);
    all.findings.push_back({std::string("lead_pysph_") + cells, rounded(lead(koshizuka_oka_1996, front), 2),
                            "a", std::string("mean lead over Koshizuka & Oka of PySPH, a/dx = ") + cells});
  }
  for (const auto& each : dam_break_fronts)
    line(std::string(each.name), [&](double T) { return each.front(T); });
  return all;
}

}  // namespace

Study dam_break() {
  return {.name = "dam_break",
          .question =
              "How far ahead of the experiments does the front of a dam break run, what does the far "
              "wall feel, and where does the energy go?",
          .keys = {{"what", ""}, {"name", ""}, {"cells", "1"}},
          .values = {{"T", "sqrt(a/(2 g))"},
                     {"front", "a"},
                     {"wall_pressure", "rho_0 g a"},
                     {"kinetic", "E_p(0)"},
                     {"potential", "E_p(0)"},
                     {"internal", "E_p(0)"},
                     {"dissipated", "E_p(0)"},
                     {"drift", "E_p(0)"},
                     {"cpu", "s"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
