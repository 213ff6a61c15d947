#include "common/window/window.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/runner/exit_code.hpp"
#include "common/runner/ink.hpp"
#include "common/runner/interrupt.hpp"
#include "common/runner/stopwatch.hpp"
#include "common/simulation/tools.hpp"
#include "common/window/display.hpp"
#include "common/window/keys.hpp"
#include "common/window/mouse.hpp"
#include "common/window/mouse_tool.hpp"
#include "common/window/overlays.hpp"
#include "common/window/panel.hpp"
#include "common/window/scene_view.hpp"
#include "common/window/screen.hpp"
#include "common/window/step_light.hpp"
#include "common/window/time_line.hpp"
#include "common/window/watch.hpp"
#include "common/words.hpp"

namespace clapotis {
namespace {

constexpr double budget = 0.012;        // seconds of computing per frame of 1/60 s
constexpr double panel_width = 400;     // [pixel] at scale 1
constexpr double widest_panel = 0.6;    // of the window: large letters leave room for the scene
constexpr double title_interval = 0.1;  // s; window managers redraw their frame for each new title

/// In ASCII, as some window managers show nothing else: the titles of the stages have one letter more.
std::string title(const Session& session) {
  const auto& simulation = session.simulation();
  std::string stage(called(session.stage().title));
  if (constexpr std::string_view accented = "É"; stage.starts_with(accented))
    stage.replace(0, accented.size(), "E");
  return fmt::format("{} | {} | t = {:.3f} s | dt = {:.1e} s | x{:.4g}", stage, simulation.scene().name,
                     session.time(), simulation.dt(), session.speed());
}

std::string beyond_limit(const StepLight& light, double dt) {
  return say(words().beyond_limit, fmt::arg("dt", fmt::format("{:.4g}", dt)),
             fmt::arg("ratio", fmt::format("{:.3g}", light.share)),
             fmt::arg("limit", called(light.limit.name, Naming::limit)),
             fmt::arg("formula", light.limit.formula));
}

class Window {
 public:
  Window(const Stage& stage, const Options& options)
      : state_{.session = Session(stage, options), .lesson = LessonPlay(stage)},
        screen_(title(state_.session), 1280, 720, options.scale) {
    state_.scale = screen_.scale();
    look_at_scene();
    state_.sight.colour_by(colouring(state_.session.simulation(), options.colour_by));
    trace_.say(fmt::format("window open {}", screen_.handle()));
  }

  int run() {
    const Interrupt interrupt;
    double last = wall_seconds();
    while (!state_.quit && !Interrupt::asked()) {
      const double now = wall_seconds(), elapsed = now - last;
      last = now;
      state_.lesson.follow(state_.session);
      const auto inputs = screen_.poll();
      moved_ = false;
      for (const Input& input : inputs) {
        moved_ = moved_ || input.kind == Input::Kind::moved;
        handle(input);
      }
      state_.session.advance(elapsed, budget);
      tool_.follow(state_);
      notice_changes();
      if (is_calm(now, !inputs.empty())) {
        screen_.rest();
        continue;
      }
      state_.cost.frame(state_.session, elapsed, screen_.frame_cpu_seconds());
      paint(elapsed);
      painted_ = now;
      name_window(elapsed);
      watch_.look(state_, screen_.size(), trace_);
      trace_.flush();
    }
    end_video();
    trace_.say("closed");
    return Interrupt::asked() ? exit_interrupted : exit_done;
  }

 private:
  /// When nothing moves, ten frames per second do: a paused lecture should not heat the laptop. Not none at
  /// all, as nobody tells when another window uncovered ours.
  bool is_calm(double now, bool input) {
    const bool moves = !state_.session.paused() && !state_.session.stopped();
    if (moves || input || !state_.typing.empty() || state_.notice.seconds_left > 0) stirred_ = now;
    return now - stirred_ > 0.5 && now - painted_ < 0.1;
  }

  void handle(const Input& input) {
    using Kind = Input::Kind;
    if (input.kind == Kind::closed) {
      state_.quit = true;
    } else if (input.kind == Kind::key_down || input.kind == Kind::character) {
      if (state_.typing.empty() && !screen_.panel_wants_text()) press(state_, input);
    } else if ((input.kind != Kind::button_down && input.kind != Kind::wheel) ||
               !screen_.panel_wants_mouse() || came_to_scene(input)) {
      if (!tool_.handle(state_, view_.view(), input)) {
        const auto& view = view_.view_at(input.at);
        auto* sides = state_.session.sides();
        const bool right = sides != nullptr && &view != &view_.view();
        mouse_.handle(state_, right ? *sides->right().simulation : state_.session.simulation(), view, input);
      }
    }
  }

  /// Whether the mouse has come to the scene since the last frame: the panel, of that frame, may still think
  /// that it has it.
  bool came_to_scene(const Input& input) {
    const bool covered =
        state_.menu_open || state_.help || (state_.session.diverged() && !state_.session.sides());
    return moved_ && !covered && view_.view_at(input.at).shows(input.at);
  }

  void look_at_scene() {
    const auto& session = state_.session;
    scene_ = session.scene();
    state_.sight.look_at_other_scene(session.simulation());
    state_.tool = has_hand(session.simulation()) ? Tool::pull : Tool::probe;
  }

  /// What concerns the look and the notices when a scene starts anew, or warns.
  void notice_changes() {
    const auto& session = state_.session;
    if (session.starts() != starts_) {
      starts_ = session.starts();
      warnings_ = 0;
      if (scene_ != session.scene()) look_at_scene();
    }
    const auto warnings = session.simulation().warnings();
    if (warnings.size() > warnings_) state_.notice = {warnings.back(), true, 10};
    warnings_ = warnings.size();
    const auto light = step_light(session.simulation());
    if (std::exchange(light_, light.colour) != light.colour && light.colour == StepLight::Colour::red)
      state_.notice = {beyond_limit(light, session.simulation().dt()), true, 10};
    if (session.diverged() && !session.sides()) state_.notice = {};  // it says all that, and more
    const bool had_stopped = std::exchange(stopped_, session.diverged().has_value());
    if (stopped_ && !had_stopped && !session.sides())
      state_.sight.viewpoint.chosen = session.diverged()->particle;
  }

  /// Takes over the scale and the theme, where the user has chosen others.
  void dress() {
    const auto theme = ink::theme();
    if (state_.scale == screen_.scale() && std::exchange(theme_, theme) == theme) return;
    screen_.dress(state_.scale);
  }

  void paint(double elapsed) {
    dress();
    const Point size = screen_.size();
    const double side = state_.panel ? std::min(panel_width * state_.scale, widest_panel * size.x) : 0;
    const bool has_past = state_.session.sides() == nullptr;
    const double strip = has_past ? std::min(time_line_height(state_.scale), size.y) : 0;
    const Box scene{{0, 0}, {size.x - side, size.y - strip}}, panel{{size.x - side, 0}, {side, size.y}};
    const Box times{{0, scene.extent.y}, {scene.extent.x, strip}};
    screen_.begin_frame(ink::sheet);
    if (scene.extent.x > 1 && scene.extent.y > 1) view_.paint(screen_.canvas(), state_, scene);
    controls_.name("domain", view_.domain());
    if (view_.beside()) controls_.name("right_half", view_.right_half());
    state_.menu_open = false;
    if (state_.panel) panel_.lay_out(state_, panel);
    if (has_past && times.extent.x > 1) lay_out_time_line(state_, times, controls_);
    state_.close_menu = false;
    lay_out_divergence(state_, scene, controls_);
    lay_out_recording(state_, view_.view().scene);
    lay_out_notice(state_, scene, elapsed);  // low, over the plots: water lies at the bottom of its scene
    lay_out_help(state_, scene);
    screen_.end_frame();
    state_.attempt(
        [&] { state_.recorder.shoot(state_.session, view_.picture(), view_.beside(), view_.curves()); });
    if (std::exchange(state_.picture_wanted, false))
      state_.attempt([&] {
        const auto file = view_.save(state_.session);
        state_.notice = {say(words().window.picture_saved, fmt::arg("file", file)), false, 6};
      });
  }

  /// One that was being made when the window was closed is whole.
  void end_video() {
    try {
      static_cast<void>(state_.recorder.end());
    } catch (const FileError& failure) {
      complain(state_.session.stage().name, failure.what());
    }
  }

  void name_window(double elapsed) {
    until_title_ -= elapsed;
    if (until_title_ > 0) return;
    until_title_ = title_interval;
    auto now = title(state_.session);
    if (now == title_) return;
    title_ = std::move(now);
    screen_.title(title_);
  }

  WindowState state_;
  Screen screen_;
  Trace trace_;
  Controls controls_{trace_};
  Panel panel_{controls_};
  SceneView view_;
  SceneMouse mouse_;
  MouseTool tool_;
  Watch watch_;
  std::string title_;
  bool moved_ = false;  ///< the mouse, since the last frame
  double until_title_ = 0;
  double stirred_ = 0, painted_ = 0;  ///< when something last happened, and was last painted [s]
  long starts_ = 0;
  std::optional<std::size_t> scene_;
  std::size_t warnings_ = 0;
  ink::Theme theme_ = ink::theme();  ///< that the controls wear
  StepLight::Colour light_ = StepLight::Colour::calm;
  bool stopped_ = false;  ///< because the run diverged
};

}  // namespace

int run_window(const Stage& stage, const Options& options) { return Window(stage, options).run(); }

WindowDoor window_door() { return {display_available, run_window}; }

}  // namespace clapotis
