#include "common/runner/listing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/runner/parameter_json.hpp"
#include "common/runner/saved_state.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view live_or_restart(const Parameter& p) {
  if (p.derived) return origin_of_results;
  return p.change == Change::live ? "live" : "restart";
}

/// Columns as wide as their widest cell; the width of a cell is its number of letters, not of bytes.
std::string table(const std::vector<std::vector<std::string>>& rows) {
  const auto letters = [](const std::string& text) {
    return std::count_if(text.begin(), text.end(),
                         [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  };
  std::vector<std::ptrdiff_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], letters(row[k]));
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      text += row[k];
      if (k + 1 < row.size()) text.append(static_cast<std::size_t>(widths[k] - letters(row[k]) + 2), ' ');
    }
    text += '\n';
  }
  return text;
}

Json as_json(const Parameter& p) {
  Json entry{{"name", p.name},
             {"meaning", meaning(p.name)},
             {"symbol", p.symbol},
             {"unit", p.unit},
             {"default", json_value(p)},
             {"allowed", p.allowed()},
             {"change", live_or_restart(p)}};
  if (p.choices.empty()) {
    const auto bound = [](double value) {
      return std::abs(value) < std::numeric_limits<double>::max() ? Json(value) : Json(nullptr);
    };
    entry["low"] = bound(p.range.low);
    entry["low_excluded"] = p.range.low_excluded;
    entry["high"] = bound(p.range.high);
    entry["integer"] = p.integer;
    entry["list"] = p.list;
  } else {
    entry["choices"] = p.choices;
  }
  return entry;
}

std::vector<std::string> as_row(const Parameter& p) {
  const auto unit = p.unit.empty() ? "-" : p.unit;
  const auto allowed = p.choices.empty() ? p.range.text() + p.form() : p.allowed();
  return {"  " + p.name,
          p.symbol,
          unit,
          p.text(),
          p.derived ? "-" : allowed,
          std::string(called(live_or_restart(p))),
          std::string(meaning(p.name))};
}

std::string parameter_listing(const std::vector<const Scene*>& scenes, bool as_object) {
  const auto& w = words();
  Json object = Json::object();
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"  " + std::string(w.column_name), std::string(w.column_symbol), std::string(w.column_unit),
                  std::string(w.column_default), std::string(w.column_range), std::string(w.column_change),
                  std::string(w.column_meaning)});
  for (const auto* scene : scenes) {
    const Simulation simulation(*scene);
    rows.push_back({scene->name});
    auto& entries = object[scene->name] = Json::array();
    for (const auto& p : simulation.parameters().all()) {
      rows.push_back(as_row(p));
      entries.push_back(as_json(p));
    }
  }
  return as_object ? object.dump(2) + "\n" : table(rows);
}

std::string name_listing(const std::vector<std::string>& names, bool as_array) {
  if (as_array) return Json(names).dump(2) + "\n";
  std::string text;
  for (const auto& name : names) text += name + "\n";
  return text;
}

/// The presets of the scenes and their values; empty if there are none.
std::string preset_listing(const std::vector<const Scene*>& scenes, bool as_object) {
  Json object = Json::object();
  std::vector<std::vector<std::string>> rows;
  for (const auto* scene : scenes) {
    if (scene->presets.empty()) continue;
    rows.push_back({scene->name});
    for (const auto& [name, values] : scene->presets) {
      std::string text;
      for (const auto& [parameter, value] : values)
        text += (text.empty() ? "" : " ") + parameter + "=" + value;
      rows.push_back({"  " + name, text});
      object[scene->name][name] = values;
    }
  }
  if (rows.empty()) return {};
  return as_object ? object.dump(2) + "\n" : table(rows);
}

/// The kernels that scenes of the stage can have; none where nothing is smoothed.
std::vector<std::string> kernels_of(const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& scene : stage.scenes) {
    const Simulation simulation(scene);
    const auto* kernel = simulation.parameters().find("kernel");
    if (kernel == nullptr) continue;
    for (const auto& name : kernel->choices)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// A run's setting beside the parameters, in the same three columns.
struct Line {
  std::string name, unit;
  Json value;
  Origin origin;
};

std::vector<Line> settings(const Stage& stage, const Options& options) {
  std::vector<Line> lines{{"stage", "", stage.name, Origin::law},
                          {"scene", "", options.scene.value, options.scene.origin},
                          {"integrator", "", options.integrator.value, options.integrator.origin},
                          {"threads", "", options.threads.value, options.threads.origin}};
  if (options.until) lines.push_back({"until", "s", options.until->value, options.until->origin});
  if (options.steps) lines.push_back({"steps", "", options.steps->value, options.steps->origin});
  return lines;
}

std::string text_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? to_text(value.get<double>()) : value.dump();
}

}  // namespace

std::string listing(const Stage& stage, const std::string& kind, const Options& options) {
  std::vector<std::string> kinds{"scenes", "parameters", "integrators"};
  if (kind == "integrators") return name_listing(integrator_names(stage.matter()), options.json);
  std::vector<std::string> names;
  std::vector<const Scene*> scenes;
  for (const auto& scene : stage.scenes) {
    names.push_back(scene.name);
    if (options.scene.origin == Origin::law || options.scene.value == scene.name) scenes.push_back(&scene);
  }
  if (kind == "scenes") return name_listing(names, options.json);
  if (kind == "parameters") return parameter_listing(scenes, options.json);
  if (const auto presets = preset_listing(scenes, options.json); !presets.empty()) {
    if (kind == "presets") return presets;
    kinds.emplace_back("presets");
  }
  if (const auto kernels = kernels_of(stage); !kernels.empty()) {
    if (kind == "kernels") return name_listing(kernels, options.json);
    kinds.emplace_back("kernels");
  }
  throw BadInput(unknown_name("list", kind, kinds));
}

std::string configuration(const Stage& stage, const Options& options) {
  const auto simulation = start_simulation(stage, options);
  std::vector<std::vector<std::string>> rows;
  Json object = Json::object();
  for (const auto& line : settings(stage, options)) {
    object[line.name] = line.value;
    rows.push_back({line.name, text_of(line.value), line.unit.empty() ? "-" : line.unit,
                    std::string(called(name_of(line.origin)))});
  }
  object["parameters"] = parameters_json(simulation->parameters());
  for (const auto& p : simulation->parameters().all())
    rows.push_back({p.name, p.text(), p.unit.empty() ? "-" : p.unit,
                    std::string(called(p.derived ? origin_of_results : name_of(p.origin)))});
  return options.json ? object.dump(2) + "\n" : table(rows);
}

}  // namespace clapotis
