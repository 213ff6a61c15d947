#include "common/runner/compare_report.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "common/runner/parameter_json.hpp"
#include "common/runner/result_json.hpp"
#include "common/runner/units.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double per_step(const Side& side) {
  return side.simulation->steps() > 0 ? side.cpu_seconds / static_cast<double>(side.simulation->steps())
                                      : none;
}

/// All columns of compare.csv with their units; L is the unit of length.
struct CompareColumn {
  std::string_view name, unit;
  double (*value)(const Comparison&, const Side& left, const Side& right);
};

double total_energy(const Side& side) { return side.runs() ? side.simulation->energy().total() : none; }
double error(const Side& side) { return side.runs() ? side.simulation->error() : none; }

constexpr std::array columns{
    CompareColumn{"t", "s", [](const auto& c, const auto&, const auto&) { return c.time(); }},
    CompareColumn{"largest_difference", "L",
                  [](const auto& c, const auto&, const auto&) {
                    return c.difference() ? c.difference()->largest : none;
                  }},
    CompareColumn{
        "rms_difference", "L",
        [](const auto& c, const auto&, const auto&) { return c.difference() ? c.difference()->rms : none; }},
    CompareColumn{"largest_over_diagonal", "1",
                  [](const auto& c, const auto&, const auto&) {
                    return c.difference() ? c.difference()->largest / c.diagonal() : none;
                  }},
    CompareColumn{"rms_over_diagonal", "1",
                  [](const auto& c, const auto&, const auto&) {
                    return c.difference() ? c.difference()->rms / c.diagonal() : none;
                  }},
    CompareColumn{"left_error", "of the reference",
                  [](const auto&, const auto& l, const auto&) { return error(l); }},
    CompareColumn{"right_error", "of the reference",
                  [](const auto&, const auto&, const auto& r) { return error(r); }},
    CompareColumn{"left_total_energy", "energy",
                  [](const auto&, const auto& l, const auto&) { return total_energy(l); }},
    CompareColumn{"right_total_energy", "energy",
                  [](const auto&, const auto&, const auto& r) { return total_energy(r); }},
};

Json side_json(const Side& side) {
  auto& s = *side.simulation;
  return {{"side", side.text},
          {"scene", s.scene().name},
          {"parameters", parameters_json(s.parameters())},
          {"integrator", s.integrator()},
          {"threads", s.threads()},
          {"dt", s.dt()},
          {"steps", s.steps()},
          {"force_evaluations", s.system().force_evaluations},
          {"simulated_seconds", s.time()},
          {"cpu_seconds", side.cpu_seconds},
          {"milliseconds_per_step", or_null(1e3 * per_step(side))},
          {"cpu_milliseconds_per_simulated_second", or_null(side.cost())},
          {"total_energy_drift", or_null(side.energy_drift())},
          {"reference", reference_json(s, side.history.largest_error())},
          {"diverged", !side.runs()},
          {"divergence", side.runs() ? "" : side.divergence->what()},
          {"warnings", s.warnings()}};
}

Json difference_json(const Difference& d, double diagonal) {
  return {{"t", d.time},
          {"largest", or_null(d.largest)},
          {"rms", or_null(d.rms)},
          {"largest_over_diagonal", or_null(d.largest / diagonal)},
          {"rms_over_diagonal", or_null(d.rms / diagonal)},
          {"particle", d.particle}};
}

Json units_json(const Side& side) {
  Json units = Json::object();
  for (const auto& column : columns)
    units[column.name] = column.unit == "energy"
                             ? energy_unit(*side.simulation)
                             : with_length(column.unit, side.simulation->scene().length_unit);
  return units;
}

std::string short_number(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-"; }

std::string side_lines(std::string_view name, const Side& side) {
  const auto& w = words();
  const auto& s = *side.simulation;
  auto text =
      say(w.compare_side_line, fmt::arg("name", name), fmt::arg("side", side.text),
          fmt::arg("integrator", s.integrator()), fmt::arg("steps", s.steps()),
          fmt::arg("dt", short_number(s.dt())), fmt::arg("cpu", short_number(side.cpu_seconds)),
          fmt::arg("cost", short_number(side.cost())), fmt::arg("step", short_number(1e3 * per_step(side))),
          fmt::arg("evaluations", side.simulation->system().force_evaluations),
          fmt::arg("drift", fmt::format("{:.2e}", side.energy_drift())));
  if (const auto& reference = s.setup().reference)
    text += say(w.summary_error, fmt::arg("measure", called(reference->measure)),
                fmt::arg("unit", reference->unit.empty() ? "" : " " + reference->unit),
                fmt::arg("reference", called(reference->name)), fmt::arg("error", short_number(s.error())),
                fmt::arg("largest", short_number(side.history.largest_error())));
  if (!side.runs()) text += say(w.summary_warning, fmt::arg("warning", side.divergence->what()));
  for (const auto& warning : s.warnings()) text += say(w.summary_warning, fmt::arg("warning", warning));
  return text;
}

}  // namespace

std::string compare_header() {
  std::string text;
  for (const auto& column : columns) {
    if (!text.empty()) text += ',';
    text += column.name;
  }
  return text += '\n';
}

std::string compare_row(const Comparison& comparison, const Side& left, const Side& right) {
  std::string text;
  for (const auto& column : columns) {
    const double value = column.value(comparison, left, right);
    if (!text.empty()) text += ',';
    text += std::isnan(value) ? "nan" : to_text(value);
  }
  return text += '\n';
}

std::string compare_manifest(const Comparison& comparison, const Side& left, const Side& right,
                             std::string_view stop_reason, const std::vector<std::string>& warnings) {
  Json json;
  json["left"] = side_json(left);
  json["right"] = side_json(right);
  json["clock"] = comparison.steps_together() ? "after each step of both"
                                              : "at multiples of every, between steps by a cubic";
  json["every"] = comparison.interval();
  json["box_diagonal"] = comparison.diagonal();
  json["largest_difference"] =
      comparison.start() ? difference_json(comparison.largest(), comparison.diagonal()) : Json(nullptr);
  json["end_difference"] = comparison.difference()
                               ? difference_json(*comparison.difference(), comparison.diagonal())
                               : Json(nullptr);
  json["ratio"] = {{"cpu_seconds", or_null(right.cpu_seconds / left.cpu_seconds)},
                   {"milliseconds_per_step", or_null(per_step(right) / per_step(left))}};
  json["simulated_seconds"] = comparison.time();
  json["stop_reason"] = stop_reason;
  json["units"] = units_json(left);
  json["warnings"] = warnings;
  return json.dump(2) + "\n";
}

std::string compare_summary(const std::filesystem::path& folder, const Comparison& comparison,
                            const Side& left, const Side& right, const std::vector<std::string>& warnings) {
  const auto& w = words();
  const auto& d = comparison.largest();
  const auto& unit = left.simulation->scene().length_unit;
  auto text = say(w.compare_title, fmt::arg("folder", folder.string()),
                  fmt::arg("time", short_number(comparison.time())));
  text += side_lines(w.compare_left, left) + side_lines(w.compare_right, right);
  if (comparison.difference())
    text +=
        say(w.compare_end, fmt::arg("largest", short_number(comparison.difference()->largest)),
            fmt::arg("rms", short_number(comparison.difference()->rms)), fmt::arg("unit", unit),
            fmt::arg("share", short_number(100 * comparison.difference()->largest / comparison.diagonal())));
  if (comparison.start())
    text += say(w.compare_largest, fmt::arg("largest", short_number(d.largest)), fmt::arg("unit", unit),
                fmt::arg("share", short_number(100 * d.largest / comparison.diagonal())),
                fmt::arg("time", short_number(d.time)), fmt::arg("particle", d.particle));
  text += say(w.compare_ratio, fmt::arg("cpu", short_number(right.cpu_seconds / left.cpu_seconds)),
              fmt::arg("step", short_number(per_step(right) / per_step(left))));
  for (const auto& warning : warnings) text += say(w.summary_warning, fmt::arg("warning", warning));
  return text;
}

std::vector<std::string> compare_warnings(const Comparison& comparison, const Side& left, const Side& right) {
  std::vector<std::string> warnings;
  const auto& w = words();
  const auto of = [](const Side& side) { return side.simulation->particles().size(); };
  if (!comparison.start() || (!comparison.difference() && left.runs() && right.runs()))
    warnings.push_back(
        say(w.compare_other_particles, fmt::arg("left", of(left)), fmt::arg("right", of(right))));
  if (comparison.start() && comparison.start()->largest > 0)
    warnings.push_back(say(w.compare_other_start,
                           fmt::arg("largest", short_number(comparison.start()->largest)),
                           fmt::arg("unit", left.simulation->scene().length_unit)));
  return warnings;
}

}  // namespace clapotis
