#include "report/studies/work_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include "common/runner/stopwatch.hpp"
#include "report/studies/conclusion.hpp"
#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

constexpr auto adaptive = "bogacki_shampine";

void run(
    Simulation& simulation, const WorkPrecision& race,
    const std::function<void(Simulation&)>& at_instant = [](Simulation&) {}) {
  for (int k = 1; k <= race.instants; ++k) {
    advance(simulation, race.until * k / race.instants);
    at_instant(simulation);
  }
}

/// Processor time of one run [s]: each takes microseconds, so as many are timed as the clock needs. They are
/// built in small batches beforehand, for that takes longer than to run them.
double seconds_of_run(const std::vector<std::string>& texts, const WorkPrecision& race, double least) {
  const std::size_t batch = std::max<std::size_t>(texts.size(), 16);  // all starts, each as often
  double taken = 0, runs = 0;
  while (taken < least) {
    std::vector<std::unique_ptr<Simulation>> waiting;
    while (waiting.size() < batch) waiting.push_back(simulation(texts[waiting.size() % texts.size()]));
    const double start = processor_seconds();
    for (const auto& each : waiting) run(*each, race);
    taken += processor_seconds() - start;
    runs += static_cast<double>(batch);
  }
  return taken / runs;
}

std::vector<Row> measure(const std::vector<std::string>& texts, const WorkPrecision& race, Effort effort) {
  double squares = 0, evaluations = 0;
  for (const auto& text : texts) {
    const auto one = simulation(text);
    run(*one, race, [&](Simulation& there) { squares += there.error() * there.error(); });
    evaluations += static_cast<double>(one->system().force_evaluations);
  }
  const auto runs = static_cast<double>(texts.size());
  const bool quick = effort == Effort::quick;
  const auto seconds = timed(quick ? 3 : 5, [&] { return seconds_of_run(texts, race, quick ? 4e-3 : 2e-2); });
  return one_row(std::sqrt(squares / runs / race.instants), seconds.median, seconds.spread,
                 evaluations / runs);
}

Point point(const WorkPrecision& race, const Lane& lane, const std::string& scheme, double dt,
            const std::string& tolerance, Effort effort) {
  std::vector<std::string> texts;
  for (auto values : lane.starts) {
    values.insert(values.end(), {{"integrator", scheme}, {"dt", to_text(dt)}});
    if (scheme == adaptive) values.emplace_back("tolerance", tolerance);
    texts.push_back(scene(lane.scene, values));
  }
  return {.key = row(lane.name, scheme, dt, tolerance),
          .measure = [=] { return measure(texts, race, effort); }};
}

std::vector<Point> points(const WorkPrecision& race, Effort effort) {
  const double longest = race.until / race.instants;
  std::vector<Point> all;
  for (const auto& lane : race.lanes)
    for (const auto& scheme : lane.schemes)
      if (scheme == adaptive)
        for (double tolerance = 1e-1; tolerance > 0.9e-12; tolerance /= std::sqrt(10))
          all.push_back(point(race, lane, scheme, longest, rounded(tolerance), effort));
      else
        for (int parts = 1; parts <= (effort == Effort::quick ? 512 : 4096); parts *= 2)
          all.push_back(point(race, lane, scheme, longest / parts, "nan", effort));
  return all;
}

/// What a scheme costs, in the words of `column`, from where its error is below `wanted` and stays so:
/// between two rows as a power of the error. NaN if it does not come so far.
double cost_of(const Table& table, const std::vector<Row>& rows, std::string_view column, double wanted) {
  double cost = std::numeric_limits<double>::quiet_NaN(), error = 0;
  for (auto each = rows.rbegin(); each != rows.rend(); ++each) {  // from the finest on
    const double coarser = table.number(*each, "error"), cheaper = table.number(*each, column);
    if (!(coarser <= wanted)) {
      if (std::isfinite(coarser) && error > 0)
        cost *= std::pow(cheaper / cost, std::log(wanted / error) / std::log(coarser / error));
      break;
    }
    cost = cheaper;
    error = coarser;
  }
  return cost;
}

constexpr std::array wanted_errors{"1e-2", "1e-4", "1e-6", "1e-8"};

/// For each wanted error what each scheme costs; and, as findings, the cheapest.
Conclusion conclude(const WorkPrecision& race, const Table& table) {
  Conclusion conclusion;
  for (const auto& [column, unit, factor] : {std::tuple{"seconds", "µs", 1e6}, {"evaluations", "", 1.0}}) {
    TextTable costs{.name = column, .header = {"error " + race.unit}, .rows = {}};
    for (const auto& scheme : race.lanes[0].schemes) costs.header.push_back(spoken(scheme));
    for (const std::string wanted : wanted_errors) {
      Row line{wanted};
      std::string best = "none", second = "none";
      double least = std::numeric_limits<double>::infinity(), next = least;
      for (const auto& scheme : race.lanes[0].schemes) {
        const auto rows = table.where({{"case", race.lanes[0].name}, {"scheme", scheme}});
        const double cost = cost_of(table, rows, column, std::stod(wanted));
        line.push_back(rounded(factor * cost));
        if (cost < least) {
          next = std::exchange(least, cost);
          second = std::exchange(best, scheme);
        } else if (cost < next) {
          next = cost;
          second = scheme;
        }
      }
      costs.rows.push_back(line);
      const auto name = std::string(column) + '_' + wanted;
      const auto of = ", by " + std::string(column) + ", for an error of " + wanted + ' ' + race.unit;
      conclusion.findings.push_back({"best_" + name, spoken(best), "", "cheapest" + of});
      conclusion.findings.push_back({"cost_" + name, rounded(factor * least), unit, "its cost"});
      conclusion.findings.push_back({"second_" + name, spoken(second), "", "next"});
      conclusion.findings.push_back({"ratio_" + name, rounded(next / least), "", "and how much dearer"});
    }
    conclusion.tables.push_back(costs);
  }
  return conclusion;
}

}  // namespace

Study work_precision(const WorkPrecision& race) {
  return {.name = race.name,
          .question = race.question,
          .keys = {{"case", ""}, {"scheme", ""}, {"dt", "s"}, {"tolerance", "1"}},
          .values = {{"error", race.unit}, {"seconds", "s"}, {"spread", "1"}, {"evaluations", "1"}},
          .points = [race](Effort effort) { return points(race, effort); },
          .conclude = [race](const Table& table) { return conclude(race, table); }};
}

}  // namespace clapotis::studies
