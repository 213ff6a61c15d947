// Paints one sheet in a window, for the test that compares it with the same sheet painted without a display.

#include <fmt/core.h>

#include "common/window/screen.hpp"
#include "common/window/trace.hpp"
#include "tests/window/example_sheet.hpp"

int main() {
  using namespace clapotis;
  Screen screen("canvas", 1280, 720, 1);
  Trace trace;
  trace.say(fmt::format("window open {}", screen.handle()));
  const testing::ExampleSheet sheet;
  for (bool open = true; open;) {
    for (const auto& input : screen.poll())
      open = open && input.kind != Input::Kind::closed && input.key != Key::escape;
    screen.begin_frame({1, 1, 1, 1});
    paint_sheet(screen.canvas(), sheet.picture, sheet.plots);
    screen.end_frame();
    trace.say("painted");
    trace.flush();
  }
}
