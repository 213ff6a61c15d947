#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include "common/runner/stopwatch.hpp"
#include "report/in_turns.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

/// The dam break with about `count` particles of fluid, flowing for some steps already.
std::unique_ptr<Simulation> dam_break(long count, int threads) {
  const double columns = std::round(std::sqrt(static_cast<double>(count) / 2));  // twice as high as wide
  auto water = simulation(
      scene("stage4/dam_break", {{"spacing", to_text(1 / columns)}, {"threads", std::to_string(threads)}}));
  advance_steps(*water, 10);
  return water;
}

/// 1, 2, 4, ... as far as the machine has processors.
std::vector<int> thread_counts() {
  const auto processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<int> counts;
  for (int threads = 1; threads < processors; threads *= 2) counts.push_back(threads);
  counts.push_back(processors);
  return counts;
}

/// Where the time of the steps between two looks at the clock went [ns per particle and step].
Row phases(const clapotis::Cost& before, const clapotis::Cost& after, double updates) {
  const auto each = [&](double clapotis::Cost::*phase) {
    return 1e9 * (after.*phase - before.*phase) / updates;
  };
  return row(each(&clapotis::Cost::neighbours), each(&clapotis::Cost::density), each(&clapotis::Cost::forces),
             each(&clapotis::Cost::walls), each(&clapotis::Cost::integration));
}

std::vector<Row> measure(long count, int times) {
  const auto one = dam_break(count, 1);
  const auto n = static_cast<double>(one->particles().size());
  const int steps = static_cast<int>(std::max(1.0, 2e5 / n));
  const auto pairs = one->model().count_pairs(one->particles());
  std::vector<Row> rows;
  for (const int threads : thread_counts()) {
    const auto several = dam_break(count, threads);
    heed_interrupt();
    const auto before = several->cost();
    const auto turns = in_turns(*one, *several, times, steps, wall_seconds);
    const double seconds = median_of(turns, &Turn::other);
    const auto [least, most] = std::minmax_element(
        turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.other < b.other; });
    auto cells = row(threads, one->particles().size(), seconds, (most->other - least->other) / seconds,
                     1e9 * seconds / n, median_of(turns, [](const Turn& t) { return 1 / t.ratio(); }),
                     several->bytes_per_particle(), static_cast<double>(pairs.candidates) / n,
                     static_cast<double>(pairs.neighbours) / n);
    const auto parts = phases(before, several->cost(), n * steps * times);
    cells.insert(cells.end(), parts.begin(), parts.end());
    rows.push_back(std::move(cells));
  }
  return rows;
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const long count : {2000L, 5000L, 10000L, 20000L, 50000L, 100000L, 200000L, 500000L, 1000000L})
    if (effort == Effort::full || count <= 50000)
      all.push_back({.key = row(count),
                     .measure = [=, times = effort == Effort::full ? 9 : 5] { return measure(count, times); },
                     .weight = 1 + static_cast<double>(count) / 5e4});
  return all;
}

/// The rows of a number of threads, in the order of the table.
std::vector<Row> with(const Table& table, const std::string& threads) {
  return table.where({{"threads", threads}});
}

TextTable by_phase(const Table& table) {
  TextTable found{
      .name = "phases",
      .header = {"particles", "threads", "sorting", "density", "acceleration", "walls", "integration"},
      .rows = {}};
  for (const auto& each : table.rows()) {
    const auto& count = table.text(each, "count");
    if (table.diverged(each) || (count != table.rows().front()[0] && count != table.rows().back()[0]))
      continue;
    found.rows.push_back({table.text(each, "particles"), table.text(each, "threads")});
    for (const char* phase : {"sorting", "density", "acceleration", "walls", "integration"})
      found.rows.back().push_back(rounded(table.number(each, phase), 2) + " ns");
  }
  return found;
}

Conclusion conclude(const Table& table) {
  const auto one = with(table, "1");
  if (one.empty()) return {};
  const auto each = table.numbers(one, "update");
  const auto [least, most] = std::minmax_element(each.begin(), each.end());
  const auto law = power_law(table.numbers(one, "particles"), table.numbers(one, "seconds"));
  Conclusion found{
      .findings = {
          {"numbers", "double", "", "all numbers of particles, in all phases, at every size"},
          {"most", table.text(one.back(), "particles"), "", "particles of fluid, the most that were tried"},
          {"least_update", rounded(*least), "ns", "for an update of one particle where that is cheapest"},
          {"most_update", rounded(*most), "ns", "where it is dearest"},
          {"exponent", rounded(law.exponent), "", "of n in the time of a step, one thread"},
          {"bytes_least", rounded(table.number(one.front(), "bytes")), "",
           "bytes of columns and model for each of the fewest particles; the walls' are in it"},
          {"bytes_most", rounded(table.number(one.back(), "bytes")), "", "and of the most"},
          {"tested", rounded(table.number(one.back(), "tested"), 2), "",
           "others tested for each, with the most"},
          {"near", rounded(table.number(one.back(), "neighbours"), 2), "", "of these within its support"},
          {"sorting_share", rounded(100 * table.number(one.back(), "sorting") / *(each.end() - 1), 2), "%",
           "of a step goes into sorting, with the most"}}};
  for (const auto& threads : table.kinds("threads")) {
    if (threads == "1") continue;
    const auto gains = table.numbers(with(table, threads), "speed_up");
    if (gains.empty()) continue;
    found.findings.push_back({"speed_up_" + threads, rounded(median(gains)), "",
                              "times as fast are " + threads + " threads, median over n"});
    found.findings.push_back(
        {"speed_up_few_" + threads, rounded(gains.front()), "", "with the fewest particles"});
    found.findings.push_back(
        {"spread_" + threads, rounded(median(table.numbers(with(table, threads), "spread")), 2), "",
         "of their times, largest less smallest over median: what else the machine did"});
    found.findings.push_back({"speed_up_many_" + threads, rounded(gains.back()), "", "with the most"});
  }
  found.tables = {by_phase(table)};
  return found;
}

}  // namespace

Study scaling() {
  return {
      .name = "scaling",
      .question = "What does a particle of liquid cost as there are more of them, and what do threads gain?",
      .keys = {{"count", "1"}},
      .values = {{"threads", "1"},
                 {"particles", "1"},
                 {"seconds", "s on the wall per step"},
                 {"spread", "1"},
                 {"update", "ns per particle and step"},
                 {"speed_up", "1"},
                 {"bytes", "bytes per particle"},
                 {"tested", "1 per particle"},
                 {"neighbours", "1 per particle"},
                 {"sorting", "ns per particle and step"},
                 {"density", "ns per particle and step"},
                 {"acceleration", "ns per particle and step"},
                 {"walls", "ns per particle and step"},
                 {"integration", "ns per particle and step"}},
      .points = points,
      .conclude = conclude};
}

}  // namespace clapotis::studies
