#include "common/runner/options.hpp"

#include <algorithm>

#include "common/runner/cairo_canvas.hpp"
#include "common/runner/command_line.hpp"
#include "common/runner/config_file.hpp"
#include "common/runner/environment.hpp"
#include "common/runner/listing.hpp"
#include "common/runner/numbers.hpp"
#include "common/runner/saved_state.hpp"
#include "common/simulation/errors.hpp"
#include "common/simulation/simulation.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr Range a_scale{.low = 0.25, .high = 8};

template <class... Args>
[[noreturn]] void refuse(std::string_view sentence, const Args&... args) {
  throw BadInput(say(sentence, args...));
}

std::string hint(std::string_view word, const std::vector<std::string>& names) {
  const auto near = nearest(word, names);
  return near.empty() ? "" : say(words().did_you_mean, fmt::arg("name", near));
}

std::string checked_integrator(const Stage& stage, const std::string& name) {
  static_cast<void>(make_integrator(name, stage.matter()));
  return name;
}

ink::Theme checked_theme(const std::string& name) {
  const auto found = std::ranges::find(ink::theme_names, name);
  if (found == ink::theme_names.end())
    throw BadInput(unknown_name("theme", name, {ink::theme_names.begin(), ink::theme_names.end()}));
  return static_cast<ink::Theme>(found - ink::theme_names.begin());
}

/// One setting, from whomever it comes.
void apply(Options& options, const Stage& stage, const std::string& name, const std::string& text,
           Origin origin) {
  if (name == "scene") options.scene = {stage.scene(text).name, origin};
  if (name == "integrator") options.integrator = {checked_integrator(stage, text), origin};
  if (name == "threads") options.threads = {static_cast<int>(option_count(name, text, thread_range)), origin};
  if (name == "until") options.until = {option_number(name, text, not_negative), origin};
  if (name == "steps") options.steps = {option_count(name, text, step_range), origin};
  if (name == "every") options.every = option_number(name, text, positive);
  if (name == "frames") options.frames = option_number(name, text, positive);
  if (name == "vtk") options.vtk = option_number(name, text, positive);
  if (name == "video-every") options.video_every = option_number(name, text, positive);
  if (name == "scale") options.scale = option_number(name, text, a_scale, "");
  if (name == "theme") options.theme = checked_theme(text);
  if (name == "seed") options.parameters.insert_or_assign("seed", Override{text, origin});
}

/// When to stop is one decision: who says a time or a number of steps overrules both of a weaker origin.
void forget_stop(Options& options, bool has_until, bool has_steps) {
  if (!has_until && !has_steps) return;
  options.until.reset();
  options.steps.reset();
}

void apply_file(Options& options, const Stage& stage, const std::string& file) {
  const auto config = read_config(file);
  if (const auto other = config.settings.find("stage");
      other != config.settings.end() && other->second != stage.name)
    refuse(words().config_other_stage, fmt::arg("file", file), fmt::arg("other", other->second),
           fmt::arg("stage", stage.name));
  from_place(file, [&] {
    for (const auto& [name, text] : config.settings) apply(options, stage, name, text, Origin::file);
  });
  if (config.of_resumed_run) options.warnings.push_back(say(words().config_resumed, fmt::arg("file", file)));
  for (const auto& [name, given] : config.parameters) options.parameters.insert_or_assign(name, given);
}

/// What a saved run was is settled; the scene may be said again.
void apply_state(Options& options, const Stage& stage, const Arguments& arguments, const std::string& file) {
  const auto& given = arguments.settings;
  if (given.contains("config")) refuse(words().resume_and_config);
  if (file.empty()) refuse(words().empty_value, fmt::arg("option", "--resume"));
  options.resume = std::make_shared<SavedState>(read_state(file, stage));
  const auto& saved = *options.resume;
  options.scene = {saved.scene, Origin::file};
  options.integrator = {saved.integrator, Origin::file};
  const auto scene = given.find("scene");
  if (scene != given.end() && stage.scene(scene->second).name != saved.scene)
    refuse(words().state_other_scene, fmt::arg("file", file), fmt::arg("other", saved.scene),
           fmt::arg("scene", scene->second));
}

/// A run that has nothing to do is a mistake.
void refuse_end_before_start(const Options& options) {
  if (!options.resume || !options.headless) return;
  const auto& saved = *options.resume;
  const auto refuse_end = [&](std::string_view option) {
    refuse(words().state_at_end, fmt::arg("file", saved.file.string()),
           fmt::arg("time", fmt::format("{:.6g}", saved.time)), fmt::arg("steps", saved.steps),
           fmt::arg("option", option));
  };
  if (options.until && options.until->value <= saved.time) refuse_end("--until");
  if (options.steps && options.steps->value <= saved.steps) refuse_end("--steps");
}

void apply_preset(Options& options, const Stage& stage, const std::string& name) {
  for (const auto& [parameter, value] : stage.scene(options.scene.value).preset(name, Origin::flag))
    options.parameters.insert_or_assign(parameter, value);
}

/// NAME=VALUE, cut in two.
std::pair<std::string, std::string> assignment_of(std::string_view sentence, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse(sentence, fmt::arg("text", text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void apply_set(Options& options, const std::vector<std::string>& assignments) {
  for (const auto& assignment : assignments) {
    auto [name, value] = assignment_of(words().set_without_equals, assignment);
    options.parameters.insert_or_assign(std::move(name), Override{std::move(value), Origin::flag});
  }
}

/// The names of the parameters that the scene has when built with `overrides`.
std::vector<std::string> parameter_names(const Stage& stage, const Options& options,
                                         const Overrides& overrides) {
  const Simulation simulation(stage.scene(options.scene.value), overrides);
  std::vector<std::string> names;
  for (const auto& p : simulation.parameters().all())
    if (!p.derived) names.push_back(p.name);
  return names;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A variable that names nothing here is not an error, since the environment serves all scenes; but it is
/// said.
void apply_environment(Options& options, const Stage& stage) {
  static const std::vector<std::string> settings{"integrator", "threads", "until", "steps",
                                                 "every",      "frames",  "vtk"};
  const auto variables = environment();
  if (variables.empty()) return;
  const auto given = [&](std::string_view name) {
    return std::any_of(variables.begin(), variables.end(), [&](const auto& v) { return v.name == name; });
  };
  forget_stop(options, given("until"), given("steps"));
  const auto names = parameter_names(stage, options, {});
  for (const auto& [variable, name, value] : variables) {
    if (contains(settings, name)) {
      from_place(variable, [&, &name = name, &value = value] {
        apply(options, stage, name, value, Origin::environment);
      });
    } else if (contains(names, name)) {
      options.parameters.insert_or_assign(name, Override{value, Origin::environment, variable});
    } else {
      options.warnings.push_back(say(words().environment_ignored, fmt::arg("variable", variable),
                                     fmt::arg("scene", options.scene.value),
                                     fmt::arg("hint", hint(name, names))));
    }
  }
}

void refuse_seed_without_chance(const Options& options, const Stage& stage) {
  auto others = options.parameters;
  others.erase("seed");
  if (!contains(parameter_names(stage, options, others), "seed"))
    refuse(words().no_seed, fmt::arg("scene", options.scene.value));
}

/// An option that does not exist may be a parameter, which is set otherwise.
void refuse_unknown(const Arguments& arguments, const Stage& stage, const Options& options) {
  const auto is_option = [](const std::string& word) { return word.starts_with('-'); };
  const auto first = std::find_if(arguments.unknown.begin(), arguments.unknown.end(), is_option);
  if (first == arguments.unknown.end()) {
    if (arguments.unknown.empty()) return;
    refuse(words().one_scene_at_a_time, fmt::arg("first", arguments.settings.at("scene")),
           fmt::arg("second", arguments.unknown.front()));
  }
  const auto option = first->substr(0, first->find('='));
  auto known = arguments.options;
  const auto parameters = parameter_names(stage, options, {});
  for (const auto& name : parameters) known.push_back("--" + name);
  const auto near = nearest(option, known);
  if (near.size() > 2 && contains(parameters, near.substr(2)) && !contains(arguments.options, near))
    refuse(words().option_is_parameter, fmt::arg("option", option), fmt::arg("name", near.substr(2)));
  refuse(words().unknown_option, fmt::arg("option", option), fmt::arg("hint", hint(option, known)));
}

void apply_files(Options& options, const Arguments& arguments) {
  const auto find = [&](std::string_view name) -> std::optional<std::filesystem::path> {
    const auto found = arguments.settings.find(name);
    if (found == arguments.settings.end()) return std::nullopt;
    if (found->second.empty()) refuse(words().empty_value, fmt::arg("option", "--" + found->first));
    return found->second;
  };
  options.out = find("out");
  options.picture = find("picture");
  options.save = find("save");
  options.video = find("video");
  check_video(options.video, options.video_every);
  if (!options.picture) return;
  try {
    static_cast<void>(picture_format(*options.picture));
  } catch (const std::invalid_argument&) {
    refuse(words().picture_extension, fmt::arg("file", options.picture->string()));
  }
}

/// What leaves files makes no sense beside a window, and would be silently lost there.
void refuse_without_headless(const Options& options, const Arguments& arguments) {
  if (options.headless) {
    if (options.beside) refuse(words().needs_window, fmt::arg("option", "--beside"));
    return;
  }
  for (const auto* name : {"out", "every", "frames", "vtk", "picture", "video", "video-every", "save"})
    if (arguments.settings.contains(name))
      refuse(words().needs_headless, fmt::arg("option", fmt::format("--{}", name)));
  for (const auto* name : {"json", "force", "quiet"})
    if (arguments.flags.at(name))
      refuse(words().needs_headless, fmt::arg("option", fmt::format("--{}", name)));
}

Options understand(const Stage& stage, const Arguments& arguments) {
  Options options;
  const auto& given = arguments.settings;
  options.scene = {stage.scenes.front().name, Origin::law};
  refuse_unknown(arguments, stage, options);
  if (const auto config = given.find("config"); config != given.end())
    apply_file(options, stage, config->second);
  if (const auto state = given.find("resume"); state != given.end())
    apply_state(options, stage, arguments, state->second);
  if (const auto scene = given.find("scene"); scene != given.end())
    apply(options, stage, "scene", scene->second, Origin::flag);
  apply_environment(options, stage);
  forget_stop(options, given.contains("until"), given.contains("steps"));
  for (const auto& [name, text] : given) apply(options, stage, name, text, Origin::flag);
  if (const auto preset = given.find("preset"); preset != given.end())
    apply_preset(options, stage, preset->second);
  apply_set(options, arguments.set);
  if (const auto quantity = given.find("colour-by"); quantity != given.end())
    options.colour_by = quantity->second;
  if (const auto beside = given.find("beside"); beside != given.end())
    options.beside = assignment_of(words().beside_without_equals, beside->second);
  if (given.contains("seed")) refuse_seed_without_chance(options, stage);
  if (!options.until && !options.steps) options.until = {default_until, Origin::law};
  apply_files(options, arguments);
  options.headless = arguments.flags.at("headless");
  options.quiet = arguments.flags.at("quiet");
  options.json = arguments.flags.at("json");
  options.paused = arguments.flags.at("paused");
  options.force = arguments.flags.at("force");
  refuse_end_before_start(options);
  return options;
}

}  // namespace

void check_video(const std::optional<std::filesystem::path>& video, const std::optional<double>& every) {
  if (video && video->extension() != ".mp4")
    refuse(words().video_extension, fmt::arg("file", video->string()));
  if (every && !video)
    refuse(words().option_without, fmt::arg("option", "--video-every"), fmt::arg("other", "--video"));
}

Command read_command_line(const Stage& stage, int argc, const char* const* argv) {
  const auto arguments = sort_arguments(stage, argc, argv);
  if (arguments.flags.at("help")) return {arguments.help, {}};
  if (arguments.flags.at("version")) return {version() + "\n", {}};
  auto options = understand(stage, arguments);
  if (const auto kind = arguments.settings.find("list"); kind != arguments.settings.end())
    return {listing(stage, kind->second, options), options};
  if (arguments.flags.at("print-config")) return {configuration(stage, options), options};
  refuse_without_headless(options, arguments);
  return {std::nullopt, options};
}

}  // namespace clapotis
