#include "report/frame_times.hpp"

#include <cmath>
#include <vector>

#include "common/runner/ink.hpp"
#include "common/runner/stopwatch.hpp"
#include "common/window/scene_view.hpp"
#include "common/window/screen.hpp"
#include "report/in_turns.hpp"
#include "stage3_grid/scenes.hpp"

namespace clapotis {

FrameTimes frame_times(long discs, int frames) {
  const Stage stage = stage3::stage();
  WindowState state{.session = Session(stage, Options{}), .lesson = LessonPlay(stage)};
  const auto side = to_text(std::ceil(40 * std::sqrt(static_cast<double>(discs))));
  for (const auto& [name, value] : Defaults{{"width", side}, {"height", side}})
    state.session.set(name, value);
  state.session.set("particles", std::to_string(discs));
  Screen screen("Clapotis", 1280, 720, 1);
  SceneView view;
  std::vector<double> ours, whole;
  for (int frame = 0; frame < frames; ++frame) {
    const double start = wall_seconds();
    screen.poll();
    state.session.step(1);
    screen.begin_frame(ink::sheet);
    view.paint(screen.canvas(), state, {{0, 0}, {880, 720}});
    screen.end_frame();
    ours.push_back(screen.frame_cpu_seconds());
    whole.push_back(wall_seconds() - start);
  }
  return {median(ours), median(whole)};
}

}  // namespace clapotis
