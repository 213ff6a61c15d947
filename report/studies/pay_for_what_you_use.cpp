#include <algorithm>
#include <cmath>

#include "common/runner/stopwatch.hpp"
#include "report/in_turns.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/one_law_more.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {

std::vector<Priced> priced_scenes() {
  using Values = std::vector<std::pair<std::string, std::string>>;
  const auto of = [](const char* law, const char* name, const Values& common, const Values& more) {
    auto values = common;
    values.insert(values.end(), more.begin(), more.end());
    return OneLawMore{law, [text = scene(name, values)] { return simulation(text); }};
  };
  const Values fine{{"spacing", "0.014"}};
  const Values tank{{"tank_width", "1"},  {"tank_height", "0.8"}, {"depth", "0.5"},
                    {"spacing", "0.008"}, {"h_over_dx", "2"},     {"alpha", "0"}};
  const Values gap{{"spacing", "1e-5"}, {"length", "1e-3"}};
  return {
      {.scene = "dam break",
       .itself = of("as it is", "stage4/dam_break", fine, {}),
       .more = {of("viscosity of strength 0", "stage4/dam_break", fine, {{"alpha", "0"}}),
                of("laminar viscosity", "stage4/dam_break", fine, {{"nu", "1e-3"}}),
                of("density as a sum", "stage4/dam_break", fine, {{"density", "summation"}}),
                of("planes in place of walls", "stage4/dam_break", fine, {{"walls", "reflect"}})}},
      {.scene = "tank of water",
       .itself = of("as it is", "stage5/standing_wave", tank, {{"amplitude", "0"}}),
       .more = {of("Newtonian viscosity", "stage5/standing_wave", tank, {{"amplitude", "0"}, {"nu", "1e-3"}}),
                of("motion of the tank", "stage5/sloshing", tank, {{"amplitude", "0.005"}, {"angle", "1"}}),
                of("the hand of the sandbox", "stage5/sandbox", tank, {})}},
      {.scene = "flow between plates",
       .itself = of("as it is", "stage5/poiseuille", gap, {}),
       .more = {of("viscosity implicit", "stage5/poiseuille", gap, {{"viscous_step", "implicit"}})}}};
}

namespace {

std::vector<Priced> all_priced() {
  auto all = priced_discs();
  all.push_back(priced_liquid());
  for (auto& each : priced_scenes()) all.push_back(std::move(each));
  return all;
}

/// What the law that `other` has and `base` has not takes by itself [ns per particle]; NaN where it moves no
/// particle.
double alone(const Simulation& base, Simulation& other) {
  const auto known = base.model().laws(), names = other.model().laws();
  const auto is_new = [&](std::string_view name) {
    return std::find(known.begin(), known.end(), name) == known.end();
  };
  std::vector<std::string_view> acting;
  other.look([&](const System& s) {
    for (const auto& law : other.model().accelerations_by_law(s, 0)) acting.push_back(law.name);
  });
  const auto seconds = other.model().law_seconds(other.system(), 5);
  for (std::size_t k = 0; k < names.size(); ++k)
    if (is_new(names[k]) && std::find(acting.begin(), acting.end(), names[k]) != acting.end())
      return 1e9 * seconds[k] / static_cast<double>(other.particles().size());
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Row> measure(const OneLawMore& itself, const OneLawMore& more, int times) {
  const auto base = itself.build(), other = more.build();
  const auto n = static_cast<double>(base->particles().size());
  const int steps = std::max(1, static_cast<int>(std::ceil(0.02 / step_cost(*base, 1, 0.02).median)));
  advance_steps(*other, 3);
  const auto turns = in_turns(*base, *other, times, steps, processor_seconds);
  heed_interrupt();
  std::vector<double> ratios;
  for (const auto& turn : turns) ratios.push_back(turn.ratio());
  std::sort(ratios.begin(), ratios.end());
  const double seconds = median_of(turns, &Turn::base), ratio = median(ratios);
  return one_row(static_cast<long>(n), 1e9 * seconds / n, 1e9 * seconds * ratio / n, ratio,
                 ratios[ratios.size() / 4], ratios[ratios.size() - 1 - ratios.size() / 4],
                 alone(*base, *other), base->bytes_per_particle(), other->bytes_per_particle(),
                 other->dt() / base->dt());
}

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const auto& each : all_priced()) {
    auto cases = each.more;
    cases.insert(cases.begin(), each.itself);  // against itself: what the measure makes of no difference
    for (std::size_t k = 0; k < cases.size(); ++k)
      all.push_back({.key = row(each.scene, k == 0 ? "itself" : cases[k].law, each.itself.law),
                     .measure = [itself = each.itself, more = cases[k], effort] {
                       return measure(itself, more, effort == Effort::full ? 31 : 7);
                     }});
  }
  return all;
}

/// What fusing laws saves: one sweep over the neighbours for all of them.
void fused(const Table& table, Conclusion& found) {
  double added = 0, by_themselves = 0;
  for (const auto& each : table.where({{"scene", "liquid"}})) {
    const double itself = table.number(each, "alone");
    if (!(itself > 20)) continue;  // ns: a law between pairs
    added += table.number(each, "before") * (table.number(each, "ratio") - 1);
    by_themselves += itself;
  }
  if (by_themselves > 0)
    found.findings.push_back(
        {"fused", rounded(100 * added / by_themselves, 2), "%",
         "of what a law between pairs of a liquid takes by itself does it add to the sweep "
         "that all share"});
}

Conclusion conclude(const Table& table) {
  TextTable prices{
      .name = "prices",
      .header = {"scene", "one law more", "ns per particle and step", "times as long", "bytes per particle"},
      .rows = {}};
  double unchanged = 0, base = 0;  // of the scene at hand [ns]
  Conclusion found;
  for (const auto& each : table.rows()) {
    if (table.diverged(each)) continue;
    const bool itself = table.text(each, "law") == "itself";
    if (itself) base = table.number(each, "before");
    if (itself) unchanged = std::max(unchanged, std::abs(table.number(each, "ratio") - 1));
    prices.rows.push_back({itself ? table.text(each, "scene") : "",
                           itself ? table.text(each, "has") : "+ " + table.text(each, "law"),
                           rounded(itself ? base : base * table.number(each, "ratio")),
                           itself ? "" : rounded(table.number(each, "ratio")),
                           rounded(table.number(each, "bytes"))});
  }
  const auto ratio = [&](const char* name, std::string_view scene, std::string_view law,
                         const std::string& meaning) {
    for (const auto& each : table.where({{"scene", scene}, {"law", law}}))
      found.findings.push_back({name, rounded(table.number(each, "ratio")), "", meaning});
  };
  found.findings.push_back({"unchanged", rounded(100 * unchanged, 2), "%",
                            "the most that a scene differs from itself: smaller differences mean nothing"});
  ratio("drag", "discs that touch", "air drag", "times as long with air drag, of discs that touch");
  ratio("springs", "discs that pass each other", "contact springs",
        "times as long with contact springs, of discs that passed each other before");
  ratio("gravity", "liquid", "gravity", "times as long with gravity, of a liquid");
  ratio("laminar", "liquid", "laminar viscosity", "times as long with laminar viscosity, of a liquid");
  ratio("tension", "liquid", "surface tension", "times as long with surface tension, of a liquid");
  ratio("walls", "liquid", "walls of particles", "times as long with walls of particles, of a liquid");
  ratio(
      "zero", "dam break", "viscosity of strength 0",
      "times as long with artificial viscosity of strength 0 as of 0.02: a zero is computed, only an absent "
      "law is free");
  ratio("implicit", "flow between plates", "viscosity implicit",
        "times as long is a step with implicit viscosity");
  for (const auto& each : table.where({{"scene", "flow between plates"}, {"law", "viscosity implicit"}}))
    found.findings.insert(
        found.findings.end(),
        {{"implicit_step", rounded(table.number(each, "step")), "",
          "times as long a time step it takes for that"},
         {"implicit_second", rounded(table.number(each, "ratio") / table.number(each, "step")), "",
          "times as long takes a second of the flow with it"}});
  fused(table, found);
  found.tables = {prices};
  return found;
}

}  // namespace

Study pay_for_what_you_use() {
  return {.name = "pay_for_what_you_use",
          .question = "What does each law that a scene names cost, in time and in memory?",
          .keys = {{"scene", ""}, {"law", ""}, {"has", ""}},
          .values = {{"particles", "1"},
                     {"before", "ns per particle and step"},
                     {"time", "ns per particle and step"},
                     {"ratio", "1"},
                     {"ratio_low", "1"},
                     {"ratio_high", "1"},
                     {"alone", "ns per particle and evaluation"},
                     {"bytes_before", "bytes per particle"},
                     {"bytes", "bytes per particle"},
                     {"step", "times the time step without it"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
