#include "common/lesson/check_lesson.hpp"

#include <fmt/core.h>

#include <limits>

#include "common/runner/compare_options.hpp"
#include "common/runner/comparison.hpp"
#include "common/runner/saved_state.hpp"
#include "common/simulation/errors.hpp"

namespace clapotis {
namespace {

/// How far a run goes.
struct Stop {
  double until = std::numeric_limits<double>::infinity();
  long steps = std::numeric_limits<long>::max();
};

/// Steps as headless runs do, as far as there is something to measure.
void carry_out(Simulation& simulation, const Stop& stop, Findings& findings, std::size_t run,
               std::string_view side = {}) {
  try {
    for (findings.look(run, simulation, side);
         simulation.time() < stop.until && simulation.steps() < stop.steps;
         findings.look(run, simulation, side)) {
      if (side.empty() && findings.complete(run)) return;
      simulation.step(stop.until);
    }
    findings.end(run, simulation, side);
  } catch (const Diverged& reason) {
    findings.diverge(run, reason.step, side);
  }
}

std::vector<const char*> arguments(const std::vector<std::string>& words, const char* program) {
  std::vector<const char*> argv{program};
  for (const auto& word : words) argv.push_back(word.c_str());
  return argv;
}

Stop stop_of(const Options& options) {
  Stop stop;
  if (options.until) stop.until = options.until->value;
  if (options.steps) stop.steps = options.steps->value;
  return stop;
}

void run_alone(const LessonRun& run, std::size_t number, std::span<const Stage> stages, Findings& findings) {
  for (const auto& stage : stages) {
    if (stage.name != run.stage) continue;
    const auto argv = arguments(run.words, run.stage.c_str());
    const auto options = read_command_line(stage, static_cast<int>(argv.size()), argv.data()).options;
    carry_out(*start_simulation(stage, options), stop_of(options), findings, number);
    return;
  }
  throw LessonError(fmt::format("README.md, line {}: there is no stage {}", run.line, run.stage));
}

std::unique_ptr<Simulation> build(const SideOptions& side) {
  return std::make_unique<Simulation>(*side.scene, side.parameters, side.integrator, side.threads);
}

/// Each side by itself, as a comparison alters neither; then both, where a check asks how far apart they
/// come.
void run_sides(const LessonRun& run, std::size_t number, const Exercise& exercise,
               std::span<const Stage> stages, Findings& findings) {
  const auto argv = arguments(run.words, "compare");
  const auto options = read_compare_options(stages, static_cast<int>(argv.size()), argv.data());
  Side left{.text = options.left->text, .stage_title = {}, .simulation = build(*options.left)};
  Side right{.text = options.right->text, .stage_title = {}, .simulation = build(*options.right)};
  const double until = options.steps ? static_cast<double>(*options.steps) * left.simulation->dt()
                                     : options.until.value_or(default_until);
  bool apart = false;
  for (const auto& check : exercise.checks) apart = apart || (check.run == number && check.side.empty());
  if (apart) {
    Comparison comparison(left, right, until, options.every.value_or(0));
    while (comparison.advance()) {
    }
    findings.note(number, "largest_difference", comparison.largest().largest);
    left.simulation = build(*options.left);
    right.simulation = build(*options.right);
  }
  carry_out(*left.simulation, {.until = until}, findings, number, "left");
  carry_out(*right.simulation, {.until = until}, findings, number, "right");
}

}  // namespace

Findings carry_out(const Exercise& exercise, std::span<const Stage> stages) {
  Findings findings(exercise);
  for (std::size_t k = 0; k < exercise.runs.size(); ++k) {
    const auto& run = exercise.runs[k];
    if (run.kind == LessonRun::Kind::run) run_alone(run, k, stages, findings);
    if (run.kind == LessonRun::Kind::compare) run_sides(run, k, exercise, stages, findings);
  }
  return findings;
}

}  // namespace clapotis
