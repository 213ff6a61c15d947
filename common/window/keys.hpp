#pragma once

#include <span>
#include <string_view>

#include "common/window/input.hpp"
#include "common/window/window_state.hpp"
#include "common/words.hpp"

namespace clapotis {

/// One shortcut: what is printed on the key, what it does in words, and in deed. A list of them drives both
/// the keyboard and the help, so that no key can be missing from either.
struct Shortcut {
  Key key;  ///< other: it is the character that counts
  char32_t character;
  std::string_view label;  ///< "Space", "N", ","
  Word Words::Window::*does;
  void (*act)(WindowState& state, bool shift);
  bool repeats = false;  ///< while the key is held
};

std::span<const Shortcut> shortcuts();

/// Does what the key or character stands for; nothing when it has no meaning.
void press(WindowState& state, const Input& input);

}  // namespace clapotis
