#include "common/runner/run_stage.hpp"

#include "common/runner/exit_code.hpp"
#include "common/runner/headless.hpp"
#include "common/runner/language_option.hpp"
#include "common/runner/saved_state.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

/// Without a window nobody would see a bad parameter in time: it is refused before the display is looked for.
void check_parameters(const Stage& stage, const Options& options) {
  static_cast<void>(start_simulation(stage, options));
}

int open_window(const Stage& stage, const Options& options, std::string_view name, const WindowDoor& window) {
  check_parameters(stage, options);
  if (window.open == nullptr || window.display_available == nullptr || !window.display_available()) {
    complain(name, say(words().no_display, fmt::arg("name", name)));
    return exit_no_display;
  }
  return window.open(stage, options);
}

int run(const Stage& stage, int argc, const char* const* argv, const WindowDoor& window) {
  choose_language(argc, argv);
  const auto name = program_name(argv[0]);
  const auto command = read_command_line(stage, argc, argv);
  if (!command.options.quiet)
    for (const auto& warning : command.options.warnings) complain(name, warning);
  if (command.answer) {
    print_result(*command.answer);
    return exit_done;
  }
  ink::use(command.options.theme);
  if (!command.options.headless) return open_window(stage, command.options, name, window);
  const int code = run_headless(stage, command.options);
  if (code == exit_interrupted) complain(name, words().interrupted);
  return code;
}

}  // namespace

int run_stage(const Stage& stage, int argc, const char* const* argv, const WindowDoor& window) {
  return with_exit_code(argv[0], [&] { return run(stage, argc, argv, window); });
}

}  // namespace clapotis
