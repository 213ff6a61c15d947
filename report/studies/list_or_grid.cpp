#include <array>
#include <cmath>

#include "report/packed_cloud.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"
#include "stage2_cloud/scenes.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis::studies {
namespace {

// All pairs of a million are 10^12: minutes for each of the steps that a median needs.
constexpr long most_in_list = 300000, most_in_grid = 1000000;

Scene cloud(std::string_view search) {
  return search == "list" ? stage2::stage().scene("cloud") : stage3::stage().scene("cloud");
}

std::vector<Row> measure(const char* search, long n) {
  // With a tiny step, so that the pack stays what it is while it is timed.
  const auto discs = packed_cloud(cloud(search), n, 1, {{"dt", {"1e-9"}}});
  heed_interrupt();
  const auto pairs = discs->model().count_pairs(discs->particles());
  const auto seconds = step_cost(*discs, 3);
  const auto each = [&](long long count) { return static_cast<double>(count) / static_cast<double>(n); };
  return one_row(seconds.median, seconds.spread, each(pairs.candidates), each(pairs.neighbours));
}

std::vector<Point> points(Effort effort) {
  const bool quick = effort == Effort::quick;
  std::vector<Point> all;
  for (const long n :
       {10L, 20L, 30L, 50L, 100L, 200L, 300L, 1000L, 3000L, 10000L, 30000L, 100000L, 300000L, 1000000L})
    for (const char* search : {"list", "grid"}) {
      const bool list = search == std::string_view("list");
      if (n > (list ? most_in_list : most_in_grid) / (quick ? 10 : 1)) continue;
      const auto size = static_cast<double>(n);
      all.push_back({.key = row(search, n),
                     .measure = [=] { return measure(search, n); },
                     .weight = 0.2 + (list ? 1.5e-9 * size * size : 2e-6 * size)});
    }
  return all;
}

/// The rows of one search, as curves.
struct Curve {
  std::vector<double> n, seconds;
};
Curve curve(const Table& table, std::string_view search, double least = 0) {
  Curve found;
  for (const auto& each : table.where({{"search", search}}))
    if (table.number(each, "particles") >= least) {
      found.n.push_back(table.number(each, "particles"));
      found.seconds.push_back(table.number(each, "seconds"));
    }
  return found;
}

/// From which n on the grid is faster, between two that were measured; none where it always or never is.
double crossover(const Curve& list, const Curve& grid) {
  for (std::size_t k = std::min(list.n.size(), grid.n.size()); k-- > 1;) {
    const double before = std::log(list.seconds[k - 1] / grid.seconds[k - 1]),
                 after = std::log(list.seconds[k] / grid.seconds[k]);
    if (before < 0 && after >= 0)
      return list.n[k - 1] * std::pow(list.n[k] / list.n[k - 1], before / (before - after));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Conclusion conclude(const Table& table) {
  const auto list = curve(table, "list"), grid = curve(table, "grid");
  const auto many_in_list = curve(table, "list", 1000), many_in_grid = curve(table, "grid", 1000);
  const auto list_law = power_law(many_in_list.n, many_in_list.seconds),
             grid_law = power_law(many_in_grid.n, many_in_grid.seconds);
  Conclusion found;
  const auto add = [&](const char* name, const std::string& value, const char* unit,
                       const std::string& meaning) {
    found.findings.push_back({name, value, unit, meaning});
  };
  add("crossover", rounded(crossover(list, grid), 2), "", "discs from which on the grid is faster");
  add("list_exponent", rounded(list_law.exponent), "", "of n in a step of the list, n >= 1000");
  add("grid_exponent", rounded(grid_law.exponent), "", "of n in a step of the grid, n >= 1000");
  if (list.n.empty() || grid.n.empty()) return found;
  add("list_to", fmt::format("{:.0f}", list.n.back()), "", "discs, the most that were measured in the list");
  add("list_million", rounded(list_law.at(1e6) / 60, 2), "min",
      "a step of a million discs in the list, were the fit to hold so far");
  add("grid_most", fmt::format("{:.0f}", grid.n.back()), "",
      "discs, the most that were measured in the grid");
  add("grid_step", rounded(1e3 * grid.seconds.back()), "ms", "a step of so many in the grid");
  add("grid_each", rounded(1e9 * grid.seconds.back() / grid.n.back()), "ns", "of that for each disc");
  for (std::size_t k = 0; k < std::min(list.n.size(), grid.n.size()); ++k)
    if (k + 1 == list.n.size())
      add("faster", rounded(list.seconds[k] / grid.seconds[k]), "",
          "times as fast as the list is the grid with the most discs that both were given");
  const auto last = table.where({{"search", "grid"}}).back();
  add("grid_tested", rounded(table.number(last, "pairs_tested")), "",
      "others tested for each disc in the grid, of the most");
  add("touched", rounded(table.number(last, "neighbours")), "", "of these touch it");
  return found;
}

}  // namespace

Study list_or_grid() {
  return {.name = "list_or_grid",
          .question = "From how many discs on is a grid of cells faster than trying all pairs?",
          .keys = {{"search", ""}, {"particles", "1"}},
          .values = {{"seconds", "s of processor time per step"},
                     {"spread", "1"},
                     {"pairs_tested", "1 per particle"},
                     {"neighbours", "1 per particle"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
