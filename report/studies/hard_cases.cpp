#include "report/studies/hard_case.hpp"

#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"

namespace clapotis::studies {
namespace {

std::vector<Point> points(Effort effort) {
  std::vector<Point> all;
  for (const auto& each : {one_point(), exact_corner(), huge_speed(), large_step(), bad_input(),
                           crowded_cell(), million_steps(), extreme_masses(), window(), any_threads()})
    all.push_back({.key = row(each.name), .measure = [each, effort] {
                     if (!each.run) return one_row(each.tried, each.criterion, "held by its tests", "tested");
                     const auto outcome = each.run(effort);
                     return one_row(each.tried, each.criterion, outcome.happened,
                                    outcome.passed ? "pass" : "fail");
                   }});
  return all;
}

Conclusion conclude(const Table& table) {
  TextTable cases{.name = "cases", .header = {"case", "tried", "criterion", "happened", ""}, .rows = {}};
  long passed = 0, failed = 0, tested = 0;
  for (const auto& each : table.rows()) {
    const auto& outcome = table.diverged(each) ? "fail" : table.text(each, "result");
    passed += outcome == "pass";
    failed += outcome == "fail";
    tested += outcome == "tested";
    cases.rows.push_back({table.text(each, "case"), table.text(each, "tried"), table.text(each, "criterion"),
                          table.text(each, "happened"), outcome});
  }
  return {.findings = {{"passed", std::to_string(passed), "", "hard cases run here and passed"},
                       {"failed", std::to_string(failed), "", "failed"},
                       {"tested", std::to_string(tested), "", "need a window and are held by its tests"}},
          .tables = {cases}};
}

}  // namespace

Study hard_cases() {
  return {.name = "hard_cases",
          .question = "What do the programs make of what breaks solvers?",
          .keys = {{"case", ""}},
          .values = {{"tried", ""}, {"criterion", ""}, {"happened", ""}, {"result", ""}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
