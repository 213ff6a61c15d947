#include "common/runner/compare_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "common/runner/command_line.hpp"
#include "common/runner/numbers.hpp"
#include "common/simulation/errors.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

const Stage& find_stage(std::span<const Stage> stages, const std::string& name) {
  std::vector<const Stage*> matching;
  std::vector<std::string> names;
  for (const auto& stage : stages) {
    names.push_back(stage.name.substr(0, stage.name.find('_')));
    if (stage.name.starts_with(name)) matching.push_back(&stage);
  }
  if (name.empty() || matching.size() != 1) throw BadInput(unknown_name("stage", name, names));
  return *matching.front();
}

/// No name begins so, but an entry of a list does.
bool begins_number(char c) { return std::string_view("0123456789.+-").find(c) != std::string_view::npos; }

void assign(SideOptions& side, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw BadInput(
        say(words().compare_assignment, fmt::arg("side", side.text), fmt::arg("text", assignment)));
  const auto name = assignment.substr(0, equals), value = assignment.substr(equals + 1);
  if (name == "integrator") {
    static_cast<void>(make_integrator(value, side.stage->matter()));
    side.integrator = value;
  } else if (name == "threads") {
    side.threads = static_cast<int>(option_count(name, value, thread_range));
  } else {
    side.parameters.insert_or_assign(name, Override{value, Origin::flag});
  }
}

/// What the words of the command line are, before they are understood.
struct Raw {
  std::vector<std::string> sides;
  std::string until, steps, every, out, video, video_every, lang;
};

void understand(CompareOptions& options, const Raw& raw, const CLI::App& app) {
  if (app.count("--until") > 0 && app.count("--steps") > 0)
    throw BadInput(std::string(words().compare_two_ends));
  if (app.count("--until") > 0) options.until = option_number("until", raw.until, positive);
  if (app.count("--steps") > 0)
    options.steps = option_count("steps", raw.steps, {.low = 1, .high = step_range.high});
  if (app.count("--every") > 0) options.every = option_number("every", raw.every, positive);
  if (app.count("--video-every") > 0)
    options.video_every = option_number("video-every", raw.video_every, positive);
  const auto file = [&](const char* option, const std::string& text) {
    if (app.count(option) == 0) return std::optional<std::filesystem::path>();
    if (text.empty()) throw BadInput(say(words().empty_value, fmt::arg("option", option)));
    return std::optional<std::filesystem::path>(text);
  };
  options.out = file("--out", raw.out);
  options.video = file("--video", raw.video);
  check_video(options.video, options.video_every);
}

const std::vector<std::string> with_value{"--until", "--steps",       "--every", "--out",
                                          "--video", "--video-every", "--lang"},
    without_value{"--force", "--json", "--quiet", "--help"};

}  // namespace

SideOptions read_side(std::span<const Stage> stages, const std::string& text) {
  const auto slash = text.find('/');
  const auto colon = std::min(text.find(':'), text.size());
  if (slash == std::string::npos || slash > colon)
    throw BadInput(say(words().compare_side, fmt::arg("side", text)));
  const auto& stage = find_stage(stages, text.substr(0, slash));
  SideOptions side{.text = text,
                   .stage = &stage,
                   .scene = &stage.scene(text.substr(slash + 1, colon - slash - 1)),
                   .parameters = {}};
  for (auto at = colon; at < text.size();) {
    auto end = std::min(text.find(',', at + 1), text.size());
    while (end + 1 < text.size() && begins_number(text[end + 1]))  // in a list: probe_x=0.1,0.5
      end = std::min(text.find(',', end + 1), text.size());
    assign(side, text.substr(at + 1, end - at - 1));
    at = end;
  }
  return side;
}

CompareOptions read_compare_options(std::span<const Stage> stages, int argc, const char* const* argv) {
  CompareOptions options;
  Raw raw;
  bool help = false;
  const auto& w = words();
  CLI::App app(std::string(w.help_compare));
  app.name("compare");
  name_parts(app);
  app.set_help_flag();
  app.allow_extras();
  raw.sides.resize(2);
  app.add_option("LEFT", raw.sides[0], std::string(w.help_side))->type_name("");
  app.add_option("RIGHT", raw.sides[1], std::string(w.help_side))->type_name("");
  app.add_option("--until", raw.until, std::string(w.help_until))->type_name("T")->take_last();
  app.add_option("--steps", raw.steps, std::string(w.help_compare_steps))->type_name("N")->take_last();
  app.add_option("--every", raw.every, std::string(w.help_compare_every))->type_name("DT")->take_last();
  app.add_option("--out", raw.out, std::string(w.help_compare_out))
      ->type_name(std::string(called("DIR")))
      ->take_last();
  app.add_option("--video", raw.video, std::string(w.help_video))
      ->type_name(std::string(called("FILE.mp4")))
      ->take_last();
  app.add_option("--video-every", raw.video_every, std::string(w.help_video_every))
      ->type_name("DT")
      ->take_last();
  app.add_option("--lang", raw.lang, std::string(w.help_lang))->type_name("en|fr")->take_last();
  app.add_flag("--force", options.force, std::string(w.help_force));
  app.add_flag("--json", options.json, std::string(w.help_compare_json));
  app.add_flag("--quiet", options.quiet, std::string(w.help_quiet));
  app.add_flag("-h,--help", help, std::string(w.help_help));
  refuse_values(argc, argv, with_value, without_value);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  if (help) {
    options.answer = app.help();
    return options;
  }
  refuse_unknown(app, with_value, without_value);
  const auto sides = app.count("LEFT") + app.count("RIGHT") + app.remaining().size();
  if (sides != 2) throw BadInput(say(w.compare_two_sides, fmt::arg("count", sides)));
  understand(options, raw, app);
  options.left = read_side(stages, raw.sides[0]);
  options.right = read_side(stages, raw.sides[1]);
  return options;
}

}  // namespace clapotis
