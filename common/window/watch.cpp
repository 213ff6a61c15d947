#include "common/window/watch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "common/laws/hand.hpp"
#include "common/runner/ink.hpp"
#include "common/window/step_light.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

std::string on(const char* what, bool yes) { return fmt::format("{} {}", what, yes ? "on" : "off"); }

/// "sides integrator=rk4", "right diverged step 12", and while both stand still "right step 12 t=...
/// largest=...".
void watch_sides(const Session& session, std::map<std::string, std::string>& now) {
  const auto* sides = session.sides();
  now["sides"] = "sides off";
  now["right diverged"] = "right diverged no";
  if (sides == nullptr) return;
  const auto& [name, value] = sides->contrast();
  const auto& right = sides->right();
  const auto& simulation = *right.simulation;
  now["sides"] = fmt::format("sides {}={}", name, value);
  if (right.divergence) now["right diverged"] = fmt::format("right diverged step {}", right.divergence->step);
  if (session.paused() || !sides->runs())
    now["right step"] = fmt::format("right step {} t={} evaluations={} largest={:.17g}", simulation.steps(),
                                    simulation.time(), simulation.system().force_evaluations,
                                    sides->comparison().largest().largest);
}

void add_lesson(const WindowState& state, std::map<std::string, std::string>& now) {
  const auto& lesson = state.lesson;
  if (lesson.empty()) return;
  now["tab"] = state.lesson_shown ? "tab lesson" : "tab scene";
  now["exercise"] = fmt::format("exercise {}", lesson.place() + 1);
  now["answer"] = on("answer", lesson.answer_shown());
  constexpr std::array progress{"none", "running", "done", "changed"};
  for (std::size_t k = 0; k < lesson.exercise().runs.size(); ++k) {
    const auto name = fmt::format("run {}", k + 1);
    now[name] = name + " " + progress[static_cast<std::size_t>(lesson.progress(k))];
  }
  for (std::size_t k = 0; k < lesson.exercise().checks.size(); ++k) {
    const auto name = fmt::format("check {}", k + 1);
    const auto& measured = lesson.findings().measured(k);
    now[name] = name + (!measured                                      ? " open"
                        : lesson.exercise().checks[k].holds(*measured) ? " holds"
                                                                       : " fails");
  }
}

std::map<std::string, std::string> lines(const WindowState& state, Point window) {
  const auto& session = state.session;
  const auto& simulation = session.simulation();
  const auto& sight = state.sight;
  std::map<std::string, std::string> now;
  now["start"] = fmt::format("started {}", session.starts());
  now["scene"] = "scene " + simulation.scene().name;
  now["preset"] = "preset " + (session.preset().empty() ? std::string("none") : session.preset());
  now["integrator"] = "integrator " + simulation.integrator();
  now["speed"] = fmt::format("speed {:.4g}", session.speed());
  now["language"] = language() == Language::french ? "language french" : "language english";
  now["pause"] = session.paused() ? "paused" : "running";
  for (const auto& p : simulation.parameters().all())
    now["parameter " + p.name] = fmt::format("parameter {}={}", p.name, p.text());
  now["colour"] = "colour by " + sight.viewpoint.colour_by;
  now["lock"] = on("range locked", sight.colour_range.locked);
  now["grid"] = on("grid", sight.viewpoint.grid);
  now["kernel"] = on("kernel", sight.viewpoint.kernel);
  now["vectors"] = on("velocities", sight.vectors);
  now["plots"] = on("plots", sight.plots);
  now["recording"] = on("recording", state.recorder.recording());
  now["theme"] = fmt::format("theme {}", ink::theme_names[static_cast<std::size_t>(ink::theme())]);
  now["scale"] = fmt::format("scale {:.4g}", state.scale);
  now["panel"] = on("panel", state.panel);
  now["help"] = on("help", state.help);
  add_lesson(state, now);
  using enum StepLight::Colour;
  const auto light = step_light(simulation).colour;
  now["light"] = std::string("step is ") + (light == red ? "red" : light == amber ? "amber" : "calm");
  now["tool"] = "tool " + tool_name(state.tool);
  now["particles"] = fmt::format("particles {}", simulation.particles().size());
  now["obstacles"] = fmt::format("obstacles {}", simulation.model().obstacles().rows());
  if (const auto* hand = simulation.model().hand())
    now["hand"] = hand->touch.pull == 0
                      ? std::string("hand open")
                      : fmt::format("hand {} {:.3g},{:.3g}", hand->touch.pull > 0 ? "pulls" : "pushes",
                                    hand->touch.at.x, hand->touch.at.y);
  now["tank"] = on("tank moved", sight.tank.norm() > 0.05);
  now["menu"] = on("menu", state.menu_open);
  now["selected"] = sight.viewpoint.chosen ? fmt::format("selected {}", *sight.viewpoint.chosen)
                                           : std::string("selected none");
  now["typing"] = "typing " + (state.typing.empty() ? std::string("nothing") : state.typing);
  now["view"] =
      fmt::format("view zoom={:.4g} moved={:.4g},{:.4g}", sight.zoom, sight.moved.x(), sight.moved.y());
  now["window"] = fmt::format("resized {}x{}", window.x, window.y);
  now["notice"] = state.notice.seconds_left > 0 ? "notice " + state.notice.text : std::string("notice none");
  now["diverged"] = session.diverged() ? fmt::format("diverged step {} particle {}", session.diverged()->step,
                                                     session.diverged()->particle)
                                       : std::string("diverged no");
  watch_sides(session, now);
  return now;
}

}  // namespace

void Watch::look(WindowState& state, Point window, Trace& trace) {
  if (!trace.active()) return;
  auto now = lines(state, window);
  auto& session = state.session;
  auto& simulation = session.simulation();
  if (session.paused() || session.stopped()) {
    now["past"] = fmt::format("past {} to {}", session.past().oldest().step,
                              std::max(session.past().newest().step, simulation.steps()));
    now["step"] = fmt::format("step {} t={} energy={:.17g}", simulation.steps(), simulation.time(),
                              simulation.energy().total());
  } else {
    seen_.erase("step");  // to be told again when it stops, even at the same step
    if (frames_++ % 20 == 0) now["time"] = fmt::format("time {:.6g}", session.time());
  }
  for (const auto& [about, line] : now) {
    auto& before = seen_[about];
    if (before == line) continue;
    before = line;
    trace.say(line);
  }
}

}  // namespace clapotis
