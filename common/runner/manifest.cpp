#include "common/runner/manifest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/runner/machine.hpp"
#include "common/runner/parameter_json.hpp"
#include "common/runner/particle_table.hpp"
#include "common/runner/result_json.hpp"
#include "common/runner/saved_state.hpp"
#include "common/runner/series.hpp"
#include "common/runner/units.hpp"
#include "common/runner/vtk_files.hpp"

namespace clapotis {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// How often each law is timed alone: once where an evaluation takes long already.
int repetitions(const Simulation& s, long steps) {
  const auto& cost = s.cost();
  const double per_step = (cost.neighbours + cost.forces) / static_cast<double>(std::max(1L, steps));
  return per_step > 0.05 ? 1 : 9;
}

Json cost_json(Simulation& s, const RunResult& result) {
  const auto& c = s.cost();
  Json phases{
      {"neighbours", c.neighbours}, {"forces", c.forces}, {"integration", c.integration}, {"walls", c.walls}};
  if (s.setup().fluid) phases["density"] = c.density;
  Json laws = Json::object();
  if (result.reason != StopReason::running) {
    const auto names = s.model().laws();
    const auto seconds = s.model().law_seconds(s.system(), repetitions(s, s.steps() - result.first_step));
    for (std::size_t k = 0; k < names.size() && k < seconds.size(); ++k) laws[names[k]] = seconds[k];
  }
  return {{"phases", phases}, {"one_evaluation_of_each_law", laws}};
}

Json units_json(const Simulation& s) {
  Json series = Json::object();
  for (const auto& column : series_columns()) {
    if (!column.has_meaning(s)) continue;
    series[column.name] = unit_of(column, s);
  }
  for (const auto& measure : s.setup().measures)
    series[measure.name] = with_length(measure.unit, s.scene().length_unit);
  return {{"series.csv", series}, {"final.csv", particle_units(s)},
          {"vtk", vtk_units(s)},  {"energy", energy_unit(s)},
          {"cost", "s"},          {"particle_updates_per_second", "1/s of cpu_seconds"}};
}

Json seed_json(const Parameters& parameters) {
  const auto* seed = parameters.find("seed");
  return seed == nullptr ? Json(nullptr) : json_value(*seed);
}

double updates_per_second(const Simulation& s, const RunResult& result) {
  return static_cast<double>(s.particles().size()) * static_cast<double>(s.steps() - result.first_step) /
         result.cpu_seconds;
}

/// A state, by its file and its instant; null where there is none.
Json state_json(const std::string& file, double time, long steps) {
  if (file.empty()) return nullptr;
  return {{"file", file}, {"simulated_seconds", time}, {"steps", steps}};
}

}  // namespace

std::string_view name_of(StopReason reason) {
  static constexpr std::array<std::string_view, 5> names{"running", "until", "steps", "interrupted",
                                                         "diverged"};
  return names[static_cast<std::size_t>(reason)];
}

const std::vector<std::string>& result_keys() {
  static const std::vector<std::string> keys{"version",
                                             "compiler",
                                             "cpu",
                                             "stop",
                                             "force_evaluations",
                                             "simulated_seconds",
                                             "resumed_from",
                                             "saved",
                                             "wall_seconds",
                                             "cpu_seconds",
                                             "particle_updates_per_second",
                                             "particles",
                                             "cost",
                                             "bytes_per_particle",
                                             "energy",
                                             "peak_memory_bytes",
                                             "reference",
                                             "units",
                                             "stop_reason",
                                             "stop_message",
                                             "warnings"};
  return keys;
}

std::string version() { return "Clapotis " CLAPOTIS_VERSION; }

std::string run_manifest(const Stage& stage, const Options& options, Simulation& s, const RunResult& result) {
  Json run;
  run["stage"] = stage.name;
  run["scene"] = s.scene().name;
  run["parameters"] = parameters_json(s.parameters());
  run["integrator"] = s.integrator();
  run["seed"] = seed_json(s.parameters());
  run["threads"] = s.threads();
  run["version"] = version();
  run["compiler"] = compiler();
  run["cpu"] = processor();
  run["stop"] = {{"until", options.until ? Json(options.until->value) : Json(nullptr)},
                 {"steps", options.steps ? Json(options.steps->value) : Json(nullptr)}};
  run["every"] = or_null(options.every);
  run["frames"] = or_null(options.frames);
  run["vtk"] = or_null(options.vtk);
  run["resumed_from"] =
      options.resume ? state_json(options.resume->file.string(), options.resume->time, options.resume->steps)
                     : Json(nullptr);
  run["saved"] = state_json(result.saved.file, result.saved.time, result.saved.steps);
  run["particles"] = s.particles().size();
  run["steps"] = s.steps();
  run["force_evaluations"] = s.system().force_evaluations;
  run["simulated_seconds"] = s.time();
  run["wall_seconds"] = result.wall_seconds;
  run["cpu_seconds"] = result.cpu_seconds;
  run["particle_updates_per_second"] = updates_per_second(s, result);
  run["cost"] = cost_json(s, result);
  run["bytes_per_particle"] = s.bytes_per_particle();
  run["peak_memory_bytes"] = peak_memory_bytes();
  run["energy"] = {{"start", energy_json(result.start)}, {"end", energy_json(result.end)}};
  run["reference"] = reference_json(s, result.largest_error);
  run["stop_reason"] = name_of(result.reason);
  run["stop_message"] = result.divergence;
  run["units"] = units_json(s);
  run["warnings"] = result.warnings;
  return run.dump(2) + "\n";
}

}  // namespace clapotis
