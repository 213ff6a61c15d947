#include "common/runner/config_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "common/runner/atomic_file.hpp"
#include "common/runner/manifest.hpp"
#include "common/runner/parameter_json.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/parameters.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_file = std::size_t{16}
                                     << 20;  // more is not a configuration, and /dev/zero never ends

std::string read_text(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) refuse_file(words().cannot_read, file, errno);
  std::string text;
  std::array<char, 1 << 16> piece;
  for (;;) {
    const auto count = read(descriptor, piece.data(), piece.size());
    const int reason = count < 0 ? errno : text.size() > largest_file ? EFBIG : 0;
    if (reason == EINTR) continue;
    if (count == 0 || reason != 0) close(descriptor);
    if (reason != 0) refuse_file(words().cannot_read, file, reason);
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

/// One file that is being read: its sentences name it.
struct Reader {
  const std::filesystem::path& file;

  template <class... Args>
  [[noreturn]] void refuse(std::string_view sentence, const Args&... args) const {
    throw BadInput(say(sentence, fmt::arg("file", file.string()), args...));
  }

  [[noreturn]] void refuse_key(const std::string& key, const std::vector<std::string>& known) const {
    const auto near = nearest(key, known);
    const auto hint = near.empty() ? "" : say(words().did_you_mean, fmt::arg("name", near));
    refuse(words().config_unknown_key, fmt::arg("key", key), fmt::arg("hint", hint));
  }

  [[nodiscard]] std::string text(const Json& value, const std::string& key) const {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_integer()) return value.dump();
    if (value.is_number()) return to_text(value.get<double>());
    refuse(words().config_wrong_kind, fmt::arg("key", key), fmt::arg("value", value.dump()));
  }
  /// A parameter's value, which may be a list.
  [[nodiscard]] std::string value(const Json& entries, const std::string& key) const {
    if (!entries.is_array()) return text(entries, key);
    std::string all;
    for (const auto& entry : entries) {
      if (!entry.is_number())
        refuse(words().config_wrong_kind, fmt::arg("key", key), fmt::arg("value", entries.dump()));
      all += (all.empty() ? "" : ",") + text(entry, key);
    }
    return all.empty() ? "none" : all;
  }
  void require_object(const Json& value, const std::string& key) const {
    if (!value.is_object())
      refuse(words().config_wrong_kind, fmt::arg("key", key), fmt::arg("value", value.dump()));
  }
};

/// A key given twice would silently lose one of its values.
Json parse(const Reader& reader, const std::string& text) {
  std::vector<std::vector<std::string>> keys;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event != Json::parse_event_t::key) return true;
    const auto key = parsed.get<std::string>();
    auto& seen = keys.back();
    if (std::find(seen.begin(), seen.end(), key) != seen.end())
      reader.refuse(words().config_key_twice, fmt::arg("key", key));
    seen.push_back(key);
    return true;
  };
  try {
    return Json::parse(text, watch, true, true);
  } catch (const Json::exception& error) {
    const auto* where = dynamic_cast<const Json::parse_error*>(&error);
    const auto end = where == nullptr ? text.size() : std::min(where->byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::string_view what = error.what();
    const auto colon = what.find(": ");
    reader.refuse(words().config_not_json, fmt::arg("line", line),
                  fmt::arg("reason", colon == std::string_view::npos ? what : what.substr(colon + 2)));
  }
}

/// {"gravity": 9.81} of a hand-written file, or {"gravity": {"value": 9.81, "unit": ..., "origin": ...}} of a
/// run.
void read_parameters(const Reader& reader, const Json& object, ConfigFile& config) {
  static const std::vector<std::string> known{"value", "unit", "origin"};
  reader.require_object(object, "parameters");
  for (const auto& [name, value] : object.items()) {
    if (!value.is_object()) {
      config.parameters[name] = {reader.value(value, name), Origin::file, reader.file.string()};
      continue;
    }
    for (const auto& [key, unused] : value.items())
      if (std::find(known.begin(), known.end(), key) == known.end()) reader.refuse_key(key, known);
    if (!value.contains("value")) reader.refuse(words().config_no_value, fmt::arg("key", name));
    if (value.contains("origin") && value["origin"] == origin_of_results) continue;
    config.parameters[name] = {reader.value(value["value"], name), Origin::file, reader.file.string(),
                               value.contains("unit") ? reader.text(value["unit"], name) : ""};
  }
}

/// What an earlier run was asked to stop at; one that was interrupted is replayed up to its last step.
void read_stop(const Reader& reader, const Json& run, ConfigFile& config) {
  if (run["stop_reason"] == name_of(StopReason::interrupted) && run.contains("steps")) {
    config.settings["steps"] = reader.text(run["steps"], "steps");
    return;
  }
  if (!run.contains("stop")) return;
  reader.require_object(run["stop"], "stop");
  for (const auto& [key, value] : run["stop"].items())
    if (!value.is_null()) config.settings[key] = reader.text(value, key);
}

void read_seed(const Reader& reader, const Json& seed, ConfigFile& config) {
  const auto text = reader.text(seed, "seed");
  const auto [entry, is_new] =
      config.parameters.try_emplace("seed", Override{text, Origin::file, reader.file.string()});
  if (!is_new && entry->second.text != text) reader.refuse(words().config_key_twice, fmt::arg("key", "seed"));
}

}  // namespace

ConfigFile read_config(const std::filesystem::path& file) {
  static const std::vector<std::string> inputs{"stage",   "scene",      "integrator", "seed",
                                               "threads", "parameters", "until",      "steps",
                                               "every",   "frames",     "vtk"};
  const Reader reader{file};
  const auto json = parse(reader, read_text(file));
  reader.require_object(json, file.filename().string());
  const bool is_a_run = json.contains("stop_reason");
  auto known = inputs;
  if (is_a_run) known.insert(known.end(), result_keys().begin(), result_keys().end());

  ConfigFile config;
  if (json.contains("parameters")) read_parameters(reader, json["parameters"], config);
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) reader.refuse_key(key, known);
    const bool is_result = std::find(inputs.begin(), inputs.end(), key) == inputs.end();
    if (is_result || key == "parameters" || (is_a_run && (value.is_null() || key == "steps"))) continue;
    if (key == "seed") {
      read_seed(reader, value, config);
    } else {
      config.settings[key] = reader.text(value, key);
    }
  }
  if (is_a_run) read_stop(reader, json, config);
  config.of_resumed_run = is_a_run && json.contains("resumed_from") && !json["resumed_from"].is_null();
  return config;
}

}  // namespace clapotis
