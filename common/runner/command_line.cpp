#include "common/runner/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

struct Setting {
  const char* option;
  const char* value;  ///< what stands for it in the help
  std::string_view Words::*help;
};

constexpr std::array settings{
    Setting{"--until", "T", &Words::help_until},
    Setting{"--steps", "N", &Words::help_steps},
    Setting{"--config", "FILE.json", &Words::help_config},
    Setting{"--integrator", "NAME", &Words::help_integrator},
    Setting{"--seed", "N", &Words::help_seed},
    Setting{"--threads", "N", &Words::help_threads},
    Setting{"--out", "DIR", &Words::help_out},
    Setting{"--every", "DT", &Words::help_every},
    Setting{"--frames", "DT", &Words::help_frames},
    Setting{"--picture", "FILE", &Words::help_picture},
    Setting{"--list", "KIND", &Words::help_list},
    Setting{"--scale", "X", &Words::help_scale},
};

struct Flag {
  const char* option;
  std::string_view Words::*help;
};

constexpr std::array flags{
    Flag{"--headless", &Words::help_headless}, Flag{"--print-config", &Words::help_print_config},
    Flag{"--force", &Words::help_force},       Flag{"--json", &Words::help_json},
    Flag{"--quiet", &Words::help_quiet},       Flag{"--paused", &Words::help_paused},
    Flag{"--version", &Words::help_version},   Flag{"-h,--help", &Words::help_help},
};

/// "-h,--help" is called help.
std::string plain_name(std::string_view option) { return std::string(option.substr(option.find("--") + 2)); }

std::string epilogue(const Stage& stage) {
  std::string scenes;
  for (const auto& scene : stage.scenes) scenes += (scenes.empty() ? "" : ", ") + scene.name;
  return say(words().help_epilogue, fmt::arg("scenes", scenes), fmt::arg("stage", stage.name),
             fmt::arg("scene", stage.scenes.front().name));
}

/// CLI11's own sentences begin with the option they are about.
[[noreturn]] void refuse(const CLI::ParseError& error, const std::vector<std::string>& options) {
  const std::string_view what = error.what();
  const std::string option(what.substr(0, what.find_first_of(": ")));
  if (std::find(options.begin(), options.end(), option) == options.end()) throw BadInput(error.what());
  const bool is_flag = std::any_of(
      flags.begin(), flags.end(), [&](const Flag& flag) { return "--" + plain_name(flag.option) == option; });
  throw BadInput(
      say(is_flag ? words().option_takes_no_value : words().option_needs_value, fmt::arg("option", option)));
}

}  // namespace

Arguments sort_arguments(const Stage& stage, int argc, const char* const* argv) {
  Arguments found;
  CLI::App app(std::string(stage.title));
  app.name(stage.name);
  app.set_help_flag();
  app.allow_extras();
  app.add_option("SCENE", found.settings["scene"], std::string(words().help_scene))->type_name("");
  app.add_option("--set", found.set, std::string(words().help_set))
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  found.options.emplace_back("--set");
  for (const auto& setting : settings) {
    app.add_option(setting.option, found.settings[plain_name(setting.option)],
                   std::string(words().*setting.help))
        ->type_name(setting.value)
        ->take_last();
    found.options.emplace_back(setting.option);
  }
  for (const auto& flag : flags) {
    app.add_flag(flag.option, found.flags[plain_name(flag.option)], std::string(words().*flag.help))
        ->take_last()
        ->disable_flag_override();
    found.options.push_back("--" + plain_name(flag.option));
  }
  app.footer(epilogue(stage));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    refuse(error, found.options);
  }
  for (const auto* option : app.get_options())
    if (option->count() == 0) found.settings.erase(plain_name(option->get_name()));
  if (app.count("SCENE") == 0) found.settings.erase("scene");
  found.unknown = app.remaining();
  found.help = app.help();
  return found;
}

}  // namespace clapotis
