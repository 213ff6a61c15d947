#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "common/runner/ink.hpp"
#include "common/window/display.hpp"
#include "common/window/scene_view.hpp"
#include "common/window/screen.hpp"
#include "report/bench/timed.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis::bench {
namespace {

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

TEST_CASE("drawing the cloud of stage 3: our own processor time per frame", "[drawing]") {
  if (!display_available()) {
    fmt::print("no display: nothing drawn\n");
    return;
  }
  constexpr int frames = 120;
  const Stage stage = stage3::stage();
  for (const long n : {500, 5000, 20000}) {
    WindowState state{.session = Session(stage, Options{}), .lesson = LessonPlay(stage)};
    const auto side = to_text(std::ceil(40 * std::sqrt(static_cast<double>(n))));
    for (const auto& [name, value] : Defaults{{"width", side}, {"height", side}})
      state.session.set(name, value);
    state.session.set("particles", std::to_string(n));
    Screen screen("Clapotis bench", 1280, 720, 1);
    SceneView view;
    std::vector<double> ours, all;
    for (int frame = 0; frame < frames; ++frame) {
      const auto start = std::chrono::steady_clock::now();
      screen.poll();
      state.session.step(1);
      screen.begin_frame(ink::sheet);
      view.paint(screen.canvas(), state, {{0, 0}, {880, 720}});
      screen.end_frame();
      ours.push_back(screen.frame_cpu_seconds());
      all.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    fmt::print(
        "{:>6} discs: {:.2f} ms of our own processor time per frame, {:.0f} frames per second (at most 60)\n",
        n, 1e3 * median(ours), 1 / median(all));
  }
}

}  // namespace clapotis::bench
