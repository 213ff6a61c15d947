#include <array>
#include <fstream>
#include <stdexcept>

#include "report/frame_times.hpp"
#include "report/key_times.hpp"
#include "report/studies/measured.hpp"
#include "report/studies/studies.hpp"
#include "tests/window/desk.hpp"

namespace clapotis::studies {
namespace {

/// A window in which a key is pressed.
struct Window {
  const char *state, *spacing;  ///< of the dam break
};
constexpr std::array windows{Window{"running", "0.03125"}, Window{"running", "0.01"},
                             Window{"paused", "0.01"}};

/// On an X server of its own, whoever else has a display.
std::vector<Row> frame(long discs, int frames) {
  const testing::Desk desk("frame-times");
  const auto answer = desk.folder() / "answer";
  testing::Child program({FRAME_TIMES_PROGRAM, std::to_string(discs), std::to_string(frames)},
                         {{"DISPLAY", desk.display()}}, answer);
  FrameTimes times{};
  if (program.await_end(120) != 0 || !(std::ifstream(answer) >> times.ours >> times.whole))
    throw std::runtime_error("frame_times has not answered");
  return one_row(discs, 1e3 * times.ours, 1 / times.whole, "nan", "nan", "nan");
}

/// The dam break's number of particles, and how long its keys wait while a step takes so long.
std::vector<Row> key(const Window& window, int presses) {
  const auto dam = simulation(scene("stage4/dam_break", {{"spacing", window.spacing}}));
  const double step = step_cost(*dam, 3).median;
  std::vector<std::string> command{STAGE4_PROGRAM, "dam_break", "--set",
                                   std::string("spacing=") + window.spacing};
  if (std::string_view(window.state) == "paused") command.emplace_back("--paused");
  const auto times = key_times(command, presses);
  const auto middle = static_cast<std::size_t>(presses / 2);
  return one_row(dam->particles().size(), "nan", "nan", 1e3 * step, 1e3 * times.at_least[middle],
                 1e3 * times.at_most[middle]);
}

std::vector<Point> points(Effort effort) {
  const bool quick = effort == Effort::quick;
  std::vector<Point> all;
  for (const long discs : {500L, 5000L, 20000L})
    all.push_back(
        {.key = row("frame", "running", discs), .measure = [=] { return frame(discs, quick ? 60 : 300); }});
  for (const auto& window : windows)
    all.push_back({.key = row("key", window.state, window.spacing),
                   .measure = [=] { return key(window, quick ? 16 : 60); }});
  return all;
}

Conclusion conclude(const Table& table) {
  Conclusion found;
  found.tables = {
      {.name = "frames", .header = {"discs", "our time [ms]", "frames/s"}, .rows = {}},
      {.name = "keys",
       .header = {"particles", "state", "a step [ms]", "answered in at least [ms]", "at most [ms]"},
       .rows = {}}};
  for (const auto& each : table.where({{"what", "frame"}})) {
    const auto& discs = table.text(each, "particles");
    const auto ours = rounded(table.number(each, "ours"));
    found.findings.push_back({"frame_" + discs, ours, "ms", "our processor time for a frame of " + discs});
    found.tables[0].rows.push_back({discs, ours, rounded(table.number(each, "frames"))});
  }
  for (const auto& each : table.where({{"what", "key"}}))
    found.tables[1].rows.push_back(
        {table.text(each, "particles"), table.text(each, "state"), rounded(table.number(each, "step")),
         rounded(table.number(each, "key_at_least")), rounded(table.number(each, "key_at_most"))});
  return found;
}

}  // namespace

Study window_times() {
  return {.name = "window_times",
          .question = "What does the window cost per frame, and how long does a key wait?",
          .keys = {{"what", ""}, {"state", ""}, {"setting", "discs, or spacing in m"}},
          .values = {{"particles", "1"},
                     {"ours", "ms of processor time per frame"},
                     {"frames", "1/s"},
                     {"step", "ms"},
                     {"key_at_least", "ms"},
                     {"key_at_most", "ms"}},
          .points = points,
          .conclude = conclude};
}

}  // namespace clapotis::studies
