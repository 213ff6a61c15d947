#include "common/window/mouse.hpp"

#include <cmath>

namespace clapotis {
namespace {

constexpr double still = 5;   // a click may shake by so many pixels
constexpr double reach = 10;  // and miss a particle by so many
constexpr double zoom_per_notch = 1.15;

}  // namespace

void SceneMouse::handle(WindowState& state, const Simulation& shown, const PictureView& view,
                        const Input& input) {
  using Kind = Input::Kind;
  const bool here = view.shows(input.at);
  if (input.kind == Kind::wheel && here) {
    state.sight.zoom_at(view, input.at, std::pow(zoom_per_notch, input.notches));
  } else if (input.kind == Kind::button_down && here) {
    if (input.button == MouseButton::left) pressed_ = input.at;
    if (input.button == MouseButton::middle) dragged_ = input.at;
  } else if (input.kind == Kind::moved && dragged_) {
    state.sight.move_by(view, {input.at.x - dragged_->x, input.at.y - dragged_->y});
    dragged_ = input.at;
  } else if (input.kind == Kind::button_up && input.button == MouseButton::middle) {
    dragged_.reset();
  } else if (input.kind == Kind::button_up && input.button == MouseButton::left && pressed_) {
    const bool clicked = std::hypot(input.at.x - pressed_->x, input.at.y - pressed_->y) <= still;
    pressed_.reset();
    if (clicked) state.sight.select_at(shown, view, input.at, reach * state.scale);
  }
}

}  // namespace clapotis
