#include "common/window/mouse_tool.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/laws/hand.hpp"
#include "common/simulation/tools.hpp"

namespace clapotis {
namespace {

constexpr double swing =
    2 * std::numbers::pi / 0.6;            // the tank hangs on the mouse as on a damped spring [1/s]
constexpr double obstacle_spacings = 2.2;  // radius of the brush: walls as thick as the kernel needs

Vector world(const PictureView& view, Point pixel) {
  const auto at = view.to_world(pixel);
  return {at.x(), at.y()};
}

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

double brush_radius(const Simulation& simulation, Tool tool) {
  if (tool == Tool::probe || tool == Tool::grab || !has_hand(simulation)) return 0;
  return tool == Tool::obstacle ? obstacle_spacings * simulation.setup().fluid->spacing
                                : simulation.model().hand()->reach;
}

bool MouseTool::handle(WindowState& state, const PictureView& view, const Input& input) {
  using Kind = Input::Kind;
  const auto& session = state.session;
  const bool usable = has_hand(session.simulation()) && !session.diverged();
  if (input.kind == Kind::moved) state.mouse = input.at;
  if (input.kind == Kind::left_window) state.mouse.reset();
  if (input.kind == Kind::button_down && usable && view.shows(input.at)) {
    const bool left = input.button == MouseButton::left;
    if (input.button == MouseButton::middle || (left && state.tool == Tool::probe)) return false;
    begin(state, view, left ? state.tool : state.tool == Tool::pull ? Tool::push : Tool::pull, input.at);
    return true;
  }
  if (!tool_) return false;
  if (input.kind == Kind::moved) go_on(state, view, input.at);
  if (input.kind == Kind::button_up && input.button != MouseButton::middle) end(state);
  if (input.kind == Kind::focus_lost) end(state);
  return true;
}

void MouseTool::begin(WindowState& state, const PictureView& view, Tool tool, Point at) {
  tool_ = tool;
  left_behind_ = false;
  begun_ = at;
  apply(state, view, at);
}

void MouseTool::go_on(WindowState& state, const PictureView& view, Point at) {
  const double brush = brush_radius(state.session.simulation(), *tool_) * view.pixels_per_unit;
  const bool stamps = *tool_ == Tool::add || *tool_ == Tool::erase || *tool_ == Tool::obstacle;
  if (!stamps || distance(at, applied_) > brush / 2) apply(state, view, at);
}

void MouseTool::end(WindowState& state) {
  const auto tool = *std::exchange(tool_, std::nullopt);
  wanted_ = {0, 0};
  if (tool == Tool::pull || tool == Tool::push)
    state.attempt([&] { state.session.act_on_both([](Simulation& s) { hold_hand(s, {0, 0}, 0); }); });
}

void MouseTool::apply(WindowState& state, const PictureView& view, Point at) {
  const Vector r = world(view, at);
  const double radius = brush_radius(state.session.simulation(), *tool_);
  applied_ = at;
  const auto act = [&](Simulation& simulation) {
    switch (*tool_) {
      case Tool::probe:
        break;
      case Tool::pull:
        hold_hand(simulation, r, 1);
        break;
      case Tool::push:
        hold_hand(simulation, r, -1);
        break;
      case Tool::add:
        add_drop(simulation, r, radius);
        break;
      case Tool::erase:
        erase(simulation, r, radius);
        break;
      case Tool::obstacle:
        draw_obstacle(simulation, r, radius);
        break;
      case Tool::grab:
        wanted_ = 1 / view.pixels_per_unit * Vector{at.x - begun_.x, begun_.y - at.y};
        break;
    }
  };
  state.attempt([&] { state.session.act_on_both(act); });
}

void MouseTool::follow(WindowState& state) {
  auto& session = state.session;
  if (std::exchange(leaps_, session.leaps()) != session.leaps()) {
    tank_ = speed_ = wanted_ = {0, 0};
    tool_.reset();
    state.sight.tank.setZero();
    left_behind_ = has_hand(session.simulation());
  }
  if (left_behind_ && !session.paused()) {
    left_behind_ = false;
    let_go(session.simulation());
  }
  const double dt = session.work().simulated;
  const bool calm = norm(speed_) == 0 && norm(tank_ - wanted_) == 0;
  if (dt == 0 || calm || session.diverged() || !has_hand(session.simulation())) return;
  // x'' = w^2 (wanted - x) - 2 w x', no more than the hand is strong
  const double most = session.simulation().model().hand()->strength;
  Vector a = swing * swing * (wanted_ - tank_) - 2 * swing * speed_;
  if (norm(a) > most) a = most / norm(a) * a;
  speed_ += std::min(dt, 0.5 / swing) * a;
  tank_ += std::min(dt, 0.5 / swing) * speed_;
  const double near = 0.1 * session.simulation().setup().radius;
  if (!tool_ && norm(tank_) < near && norm(speed_) < swing * near) tank_ = speed_ = a = {0, 0};
  session.act_on_both([&](Simulation& s) { shake_tank(s, a); });
  state.sight.tank = {tank_.x, tank_.y};
}

}  // namespace clapotis
