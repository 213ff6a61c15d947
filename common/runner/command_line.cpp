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
  Word Words::*help;
};

constexpr std::array settings{
    Setting{"--until", "T", &Words::help_until},
    Setting{"--steps", "N", &Words::help_steps},
    Setting{"--config", "FILE.json", &Words::help_config},
    Setting{"--preset", "NAME", &Words::help_preset},
    Setting{"--integrator", "NAME", &Words::help_integrator},
    Setting{"--seed", "N", &Words::help_seed},
    Setting{"--threads", "N", &Words::help_threads},
    Setting{"--out", "DIR", &Words::help_out},
    Setting{"--every", "DT", &Words::help_every},
    Setting{"--frames", "DT", &Words::help_frames},
    Setting{"--vtk", "DT", &Words::help_vtk},
    Setting{"--colour-by", "NAME", &Words::help_colour_by},
    Setting{"--picture", "FILE", &Words::help_picture},
    Setting{"--video", "FILE.mp4", &Words::help_video},
    Setting{"--video-every", "DT", &Words::help_video_every},
    Setting{"--save", "FILE", &Words::help_save},
    Setting{"--resume", "FILE", &Words::help_resume},
    Setting{"--list", "KIND", &Words::help_list},
    Setting{"--beside", "NAME=VALUE", &Words::help_beside},
    Setting{"--scale", "X", &Words::help_scale},
    Setting{"--theme", "NAME", &Words::help_theme},
    Setting{"--lang", "en|fr", &Words::help_lang},
};

struct Flag {
  const char* option;
  Word Words::*help;
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

}  // namespace

void name_parts(CLI::App& app) {
  app.get_formatter()->label("Usage", std::string(words().help_usage));
  app.get_formatter()->label("Positionals", std::string(words().help_arguments));
}

void refuse_values(int argc, const char* const* argv, const std::vector<std::string>& takes_value,
                   const std::vector<std::string>& takes_none) {
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    for (const auto& option : takes_none)
      if (word.starts_with(option + '='))
        throw BadInput(say(words().option_takes_no_value, fmt::arg("option", option)));
    const bool has_value = k + 1 < argc && !std::string_view(argv[k + 1]).starts_with("--");
    if (!has_value && std::find(takes_value.begin(), takes_value.end(), word) != takes_value.end())
      throw BadInput(say(words().option_needs_value, fmt::arg("option", word)));
  }
}

void refuse_unknown(const CLI::App& app, const std::vector<std::string>& takes_value,
                    const std::vector<std::string>& takes_none) {
  for (const auto& word : app.remaining()) {
    if (!word.starts_with('-')) continue;
    auto known = takes_value;
    known.insert(known.end(), takes_none.begin(), takes_none.end());
    const auto near = nearest(word, known);
    const auto hint = near.empty() ? "" : say(words().did_you_mean, fmt::arg("name", near));
    throw BadInput(say(words().unknown_option, fmt::arg("option", word), fmt::arg("hint", hint)));
  }
}

Arguments sort_arguments(const Stage& stage, int argc, const char* const* argv) {
  Arguments found;
  CLI::App app(std::string(called(stage.title)));
  app.name(stage.name);
  name_parts(app);
  app.set_help_flag();
  app.allow_extras();
  app.add_option("SCENE", found.settings["scene"], std::string(words().help_scene))->type_name("");
  app.add_option("--set", found.set, std::string(words().help_set))
      ->type_name(std::string(called("NAME=VALUE")))
      ->allow_extra_args(false);
  found.options.emplace_back("--set");
  for (const auto& setting : settings) {
    app.add_option(setting.option, found.settings[plain_name(setting.option)],
                   std::string(words().*setting.help))
        ->type_name(std::string(called(setting.value)))
        ->take_last();
    found.options.emplace_back(setting.option);
  }
  std::vector<std::string> without_value;
  for (const auto& flag : flags) {
    app.add_flag(flag.option, found.flags[plain_name(flag.option)], std::string(words().*flag.help))
        ->take_last();
    without_value.push_back("--" + plain_name(flag.option));
  }
  refuse_values(argc, argv, found.options, without_value);
  found.options.insert(found.options.end(), without_value.begin(), without_value.end());
  app.footer(epilogue(stage));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  for (const auto* option : app.get_options())
    if (option->count() == 0) found.settings.erase(plain_name(option->get_name()));
  if (app.count("SCENE") == 0) found.settings.erase("scene");
  found.unknown = app.remaining();
  found.help = app.help();
  return found;
}

}  // namespace clapotis
