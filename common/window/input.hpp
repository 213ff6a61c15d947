#pragma once

#include "common/runner/canvas.hpp"

namespace clapotis {

/// The keys the window or a text field acts on; every other key is `other`. A letter is the one the user's
/// keyboard layout prints, so that shortcuts work on AZERTY as well.
// clang-format off
enum class Key {
  other, a, b, c, e, g, h, k, l, n, r, v, x, y, z, space, enter, escape, backspace, del, tab, left, right, up, down,
  page_up, page_down, home, end, shift, control, alt, f1, f2, f3, f4,
  f5, f9, f10, f12
};
// clang-format on

enum class MouseButton { left, right, middle };

/// One thing the user did to the window. Only the fields its kind names carry a meaning.
struct Input {
  enum class Kind {
    key_down,     ///< key, shift, control, alt
    key_up,       ///< key, shift, control, alt
    character,    ///< character: what the layout made of the keys
    button_down,  ///< button, at
    button_up,    ///< button, at
    moved,        ///< at
    wheel,        ///< notches (positive: away from the user), at
    left_window,  ///< the mouse is elsewhere
    focus_gained,
    focus_lost,
    resized,  ///< at: the new width and height [pixel]
    closed    ///< the window's own close button
  };
  Kind kind;
  Key key = Key::other;
  bool repeat = false;  ///< of key_down: the key is held
  bool shift = false, control = false, alt = false;
  char32_t character = 0;
  MouseButton button = MouseButton::left;
  double notches = 0;
  Point at{};
};

}  // namespace clapotis
