#include <algorithm>
#include <cmath>
#include <map>

#include "common/simulation/errors.hpp"
#include "common/simulation/time_step.hpp"
#include "report/stages.hpp"
#include "report/studies/hard_case.hpp"
#include "report/studies/measured.hpp"

namespace clapotis::studies {
namespace {

bool same_bits(const Simulation& a, const Simulation& b) {
  const auto &p = a.particles(), &q = b.particles();
  return p.size() == q.size() && (p.position == q.position).all() && (p.velocity == q.velocity).all();
}

/// Runs a scene with so many times the step that its limit of stability allows. Returns the step that was
/// refused, 0 when there was none; -1 when it was not announced, not explained, or left no good state.
long step_lost(const char* name, std::vector<std::pair<std::string, std::string>> values, double times) {
  double limit = std::numeric_limits<double>::infinity();
  for (const auto& each : simulation(scene(name, values))->limits())
    if (each.stability) limit = std::min(limit, each.limit);
  values.emplace_back("dt", to_text(times * limit));
  const auto text = scene(name, values);
  const auto run = simulation(text);
  if (times > 1 && run->warnings().empty()) return -1;
  try {
    advance_steps(*run, 1000);
  } catch (const Diverged& lost) {
    const std::string sentence = lost.what();
    const auto twin = simulation(text);
    advance_steps(*twin, lost.step - 1);
    const bool says = sentence.find("step " + std::to_string(lost.step)) != sentence.npos &&
                      sentence.find("particle " + std::to_string(lost.particle)) != sentence.npos &&
                      sentence.find(" limit ") != sentence.npos;
    return says && same_bits(*run, *twin) ? lost.step : -1;
  }
  return 0;
}

Outcome go_beyond_limits(Effort /*effort*/) {
  const std::vector<std::pair<const char*, std::vector<std::pair<std::string, std::string>>>> cases{
      {"stage1/drop", {{"drag", "1e4"}, {"vy0", "-1"}, {"integrator", "explicit_euler"}}},
      {"stage2/stack", {{"drag", "0"}}},
      {"stage4/still_water", {{"spacing", "0.05"}}}};
  std::map<double, std::string> steps;
  bool passed = true;
  for (const auto& [name, values] : cases)
    for (const double times : {1.0, 2.0, 5.0}) {
      const long lost = step_lost(name, values, times);
      steps[times] += (steps[times].empty() ? "" : " and ") + std::to_string(lost);
      passed = passed && (times > 1 ? lost > 0 && lost <= 50 : lost == 0);
    }
  return {fmt::format("1x: 1000 steps done{}; 2x: found at step {}; 5x: at step {}; each announced before",
                      passed ? "" : fmt::format(" (lost at {})", steps[1]), steps[2], steps[5]),
          passed};
}

/// How a scene takes what no parameter can be.
struct Refused {
  long tried = 0, accepted = 0, unclear = 0;
  std::string example;
};

void try_value(const Scene& scene, const Parameter& p, const std::string& value, Refused& refused) {
  ++refused.tried;
  try {
    const Simulation run(scene, {{p.name, {value}}});
    ++refused.accepted;
    refused.example = scene.name + ": " + p.name + " = " + value;
  } catch (const BadInput& bad) {
    const std::string sentence = bad.what();
    for (const auto& part : {p.name, value, p.allowed()})
      if (sentence.find(part) == sentence.npos) {
        ++refused.unclear;
        refused.example = sentence;
        break;
      }
  }
}

/// Every parameter of a scene, with values that are no numbers and with such as are out of its range.
void try_scene(const Scene& scene, Refused& refused) {
  const Simulation usual(scene);
  for (const auto& p : usual.parameters().all()) {
    if (p.derived) continue;
    heed_interrupt();
    for (const char* value : {"nan", "inf", "-inf", "1e999", "ten"}) try_value(scene, p, value, refused);
    for (const double value : {0.0, -1.0, -1e-300, 1e300, 0.5})
      if (p.choices.empty() && (!p.range.contains(value) || (p.integer && value != std::floor(value))))
        try_value(scene, p, to_text(value), refused);
  }
}

Outcome give_bad_values(Effort effort) {
  Refused refused;
  long scenes = 0;
  for (const auto& stage : all_stages())
    for (const auto& scene : stage.scenes) {
      if (effort == Effort::quick && &scene != &stage.scenes.front()) continue;
      ++scenes;
      try_scene(scene, refused);
    }
  auto happened = fmt::format(
      "{} values in {} scenes; {} accepted; {} refused without naming parameter value "
      "and range with its unit",
      refused.tried, scenes, refused.accepted, refused.unclear);
  if (!refused.example.empty()) happened += "; last: " + refused.example;
  for (auto& c : happened)  // which no cell of a CSV may have
    if (c == ',' || c == '"' || c == '\n') c = ';';
  return {happened, refused.accepted == 0 && refused.unclear == 0};
}

Outcome share_between_threads(Effort effort) {
  const long steps = effort == Effort::quick ? 50 : 500;
  long runs = 0, differ = 0;
  for (const auto& [name, values] :
       std::vector<std::pair<const char*, std::vector<std::pair<std::string, std::string>>>>{
           {"stage3/cloud", {{"particles", "5000"}, {"width", "2400"}, {"height", "1800"}}},
           {"stage4/dam_break", {}},
           {"stage4/elliptical_drop", {}},
           {"stage5/jet", {}}}) {
    const auto with = [&](int threads) {
      auto more = values;
      more.emplace_back("threads", std::to_string(threads));
      auto run = simulation(scene(name, more));
      advance_steps(*run, steps);
      return run;
    };
    const auto one = with(1);
    for (const int threads : {1, 2, 3, 4}) {
      ++runs;
      if (!same_bits(*one, *with(threads))) ++differ;
    }
  }
  return {fmt::format("{} runs of {} steps with 1 to 4 threads; {} differ in any bit from one thread", runs,
                      steps, differ),
          differ == 0};
}

}  // namespace

HardCase large_step() {
  return {
      "steps beyond the limit",
      "thick air (Euler); a stack of springs; still water; 1 2 and 5 times (exit code and files: "
      "tests/common/runner_test.cpp)",
      "1000 steps at 1x; else announced; found within 50 steps with step particle and limit; the last good "
      "state kept bit for bit",
      go_beyond_limits};
}
HardCase bad_input() {
  return {"values that cannot be", "NaN inf words and values out of range for every parameter",
          "refused before anything runs; parameter value range and unit named", give_bad_values};
}
HardCase window() {
  return {"window closed minimised resized stalled",
          "not here: tests/window/window_test.cpp (size zoom panel and overlays; a minimised window) and "
          "session_test.cpp (after a stall nothing is caught up; how many frames it took)",
          "same bits with and without; nothing caught up", nullptr};
}
HardCase any_threads() {
  return {"same seed any number of threads", "a cloud; a dam break; a drop; a jet", "the same bits",
          share_between_threads};
}

}  // namespace clapotis::studies
